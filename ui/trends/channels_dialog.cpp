// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/channels_dialog.h"

#include "catalog/units.h"
#include "text/language.h"
#include "ui/common/dialog_sizes.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_text.h"

#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
namespace {
constexpr int idRole = Qt::UserRole;
constexpr int nameColumn = 0;
constexpr int unitColumn = 1;
constexpr double maxScale = 1e6;
} // namespace

ChannelsDialog::ChannelsDialog(const session::ServoRegistry& registry,
                               std::vector<TrendCurve> curves, QWidget* parent)
    : QDialog(parent)
    , m_registry(registry)
    , m_curves(std::move(curves))
{
    setObjectName(QStringLiteral("channelsDialog"));
    rememberSize(*this);
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    followLanguage(this, [this] { retranslate(); });
    resize(460, 560);
    connect(&registry, &session::ServoRegistry::servoAdded, this, &ChannelsDialog::fill);
    connect(&registry, &session::ServoRegistry::servoRemoved, this, &ChannelsDialog::fill);
    connect(&registry, &session::ServoRegistry::servosCleared, this, &ChannelsDialog::fill);
}

void ChannelsDialog::build()
{
    auto* column = new QVBoxLayout(this);
    m_find = new QLineEdit(this);
    m_find->setObjectName(QStringLiteral("channelFind"));
    m_find->setClearButtonEnabled(true);
    m_tree = new QTreeWidget(this);
    m_tree->setObjectName(QStringLiteral("channelTree"));
    m_tree->setColumnCount(2);
    m_tree->header()->setSectionResizeMode(nameColumn, QHeaderView::Stretch);
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(unitColumn, QHeaderView::ResizeToContents);
    QFormLayout* style = buildStyle();
    auto* buttons = new QHBoxLayout;
    m_reset = new QPushButton(this);
    m_reset->setObjectName(QStringLiteral("channelUsual"));
    m_close = new QPushButton(this);
    m_close->setObjectName(QStringLiteral("channelClose"));
    buttons->addWidget(m_reset);
    buttons->addStretch();
    buttons->addWidget(m_close);
    column->addWidget(m_find);
    column->addWidget(m_tree, 1);
    column->addLayout(style);
    column->addLayout(buttons);
    for (QPushButton* button : {m_color, m_reset, m_close})
        button->setAutoDefault(false);
    connect(m_find, &QLineEdit::textChanged, this, &ChannelsDialog::filter);
    connect(m_tree, &QTreeWidget::itemChanged, this, &ChannelsDialog::onItemChanged);
    connect(m_tree, &QTreeWidget::currentItemChanged, this, &ChannelsDialog::showStyle);
    connect(m_color, &QPushButton::clicked, this, &ChannelsDialog::pickColor);
    connect(m_close, &QPushButton::clicked, this, &QDialog::close);
    connect(m_reset, &QPushButton::clicked, this, [this] {
        setCurves(defaultCurves());
        Q_EMIT curvesChanged(m_curves);
    });
}

QFormLayout* ChannelsDialog::buildStyle()
{
    auto* style = new QFormLayout;
    m_color = new QPushButton(this);
    m_color->setObjectName(QStringLiteral("channelColour"));
    const auto number = [this](const char* name) {
        auto* box = new QDoubleSpinBox(this);
        box->setObjectName(QString::fromLatin1(name));
        box->setRange(-maxScale, maxScale);
        box->setDecimals(3);
        connect(box, &QDoubleSpinBox::valueChanged, this, &ChannelsDialog::applyStyle);
        return box;
    };
    m_scale = number("channelScale");
    m_offset = number("channelOffset");
    style->addRow(new QLabel(this), m_color);
    style->addRow(new QLabel(this), m_scale);
    style->addRow(new QLabel(this), m_offset);
    for (QWidget* field : std::initializer_list<QWidget*>{m_color, m_scale, m_offset})
        static_cast<QLabel*>(style->labelForField(field))->setBuddy(field);
    return style;
}

void ChannelsDialog::setCurves(std::vector<TrendCurve> curves)
{
    m_curves = std::move(curves);
    fill();
}

TrendCurve* ChannelsDialog::curve(const QString& id)
{
    const auto found = std::find_if(m_curves.begin(), m_curves.end(),
                                    [&](const TrendCurve& one) { return one.id() == id; });
    return found != m_curves.end() ? &*found : nullptr;
}

TrendCurve* ChannelsDialog::current()
{
    const QTreeWidgetItem* item = m_tree->currentItem();
    return item != nullptr ? curve(item->data(nameColumn, idRole).toString()) : nullptr;
}

QTreeWidgetItem* ChannelsDialog::addRow(QTreeWidgetItem* parent, const QString& id,
                                        const QString& name, const QString& unit)
{
    auto* row = new QTreeWidgetItem(parent, {name, unit});
    row->setData(nameColumn, idRole, id);
    row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    const TrendCurve* known = curve(id);
    row->setCheckState(nameColumn,
                       known != nullptr && known->visible ? Qt::Checked : Qt::Unchecked);
    row->setToolTip(nameColumn, name);
    return row;
}

void ChannelsDialog::addBuiltIn()
{
    auto* group = new QTreeWidgetItem(m_tree, {tr("The selected servo"), QString()});
    for (const QString& key : builtInKeys())
        addRow(group, QStringLiteral("*/") + key, builtInName(key), {});
    group->setExpanded(true);
}

void ChannelsDialog::addServo(const session::ServoEntry& entry)
{
    const device::Servo& servo = entry.servo;
    if (!servo.profile)
        return;
    const QString title = tr("ID %1 · %2").arg(servo.id).arg(servo.profile->modelName);
    auto* group = new QTreeWidgetItem(m_tree, {title, QString()});
    const QString prefix = QString::number(servo.id) + QLatin1Char('/');
    addRow(group, prefix + session::errorKey, builtInName(QStringLiteral("@error")), {});
    for (const catalog::Register& reg : servo.profile->registers) {
        if (servo.measures(reg))
            addRow(group, prefix + reg.key, text::localized(reg.name),
                   catalog::unitSuffix(servo.meaning(reg).unit).trimmed());
    }
}

void ChannelsDialog::fill()
{
    m_filling = true;
    const QString now = m_tree->currentItem() != nullptr
                            ? m_tree->currentItem()->data(nameColumn, idRole).toString()
                            : QString();
    m_tree->clear();
    addBuiltIn();
    for (const session::ServoRef ref : m_registry.order())
        addServo(*m_registry.servo(ref));
    m_filling = false;
    filter(m_find->text());
    for (QTreeWidgetItemIterator row(m_tree); *row != nullptr; ++row) {
        if (!now.isEmpty() && (*row)->data(nameColumn, idRole).toString() == now)
            m_tree->setCurrentItem(*row);
    }
    showStyle();
}

void ChannelsDialog::filter(const QString& text)
{
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        QTreeWidgetItem* group = m_tree->topLevelItem(i);
        int shown = 0;
        for (int j = 0; j < group->childCount(); ++j) {
            QTreeWidgetItem* row = group->child(j);
            const bool fits = row->text(nameColumn).contains(text, Qt::CaseInsensitive) ||
                              row->data(nameColumn, idRole).toString().contains(text);
            row->setHidden(!fits);
            shown += fits ? 1 : 0;
        }
        group->setHidden(shown == 0);
        if (!text.isEmpty())
            group->setExpanded(true);
    }
}

void ChannelsDialog::onItemChanged(QTreeWidgetItem* item)
{
    const QString id = item->data(nameColumn, idRole).toString();
    if (m_filling || id.isEmpty())
        return;
    const bool isChecked = item->checkState(nameColumn) == Qt::Checked;
    if (TrendCurve* known = curve(id))
        known->visible = isChecked;
    else if (isChecked)
        m_curves.push_back(TrendCurve::fromId(id));
    m_tree->setCurrentItem(item);
    showStyle();
    Q_EMIT curvesChanged(m_curves);
}

void ChannelsDialog::showStyle()
{
    const TrendCurve* now = current();
    const bool shown = now != nullptr && now->visible;
    for (QWidget* field : std::initializer_list<QWidget*>{m_color, m_scale, m_offset})
        field->setEnabled(shown);
    const QSignalBlocker scaleBlocker(m_scale);
    const QSignalBlocker offsetBlocker(m_offset);
    m_scale->setValue(shown ? now->scale : 1);
    m_offset->setValue(shown ? now->offset : 0);
    QPixmap swatch(16, 16);
    swatch.fill(shown && now->color.isValid() ? now->color : QColor(Qt::transparent));
    m_color->setIcon(QIcon(swatch));
    m_color->setText(shown && now->color.isValid() ? now->color.name() : tr("automatic"));
}

void ChannelsDialog::applyStyle()
{
    TrendCurve* now = current();
    if (now == nullptr)
        return;
    now->scale = m_scale->value() != 0 ? m_scale->value() : 1;
    now->offset = m_offset->value();
    Q_EMIT curvesChanged(m_curves);
}

void ChannelsDialog::pickColor()
{
    const TrendCurve* now = current();
    if (now == nullptr)
        return;
    auto* dialog = new QColorDialog(now->color.isValid() ? now->color : Qt::blue, this);
    dialog->setObjectName(QStringLiteral("colourDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const QString id = now->id();
    connect(dialog, &QColorDialog::colorSelected, this, [this, id](const QColor& color) {
        TrendCurve* meant = curve(id);
        if (meant == nullptr || !color.isValid())
            return;
        meant->color = color;
        showStyle();
        Q_EMIT curvesChanged(m_curves);
    });
    dialog->open();
}

void ChannelsDialog::retranslate()
{
    setWindowTitle(tr("Channels"));
    m_find->setPlaceholderText(tr("Find a register"));
    m_find->setAccessibleName(tr("Find a register"));
    m_find->setToolTip(tr("Part of the register name"));
    m_tree->setHeaderLabels({tr("Channel"), tr("Unit")});
    m_tree->setAccessibleName(tr("Channels"));
    m_tree->setToolTip(tr("Selected registers are read and shown"));
    const auto* style = findChild<QFormLayout*>();
    setFieldText(style, m_color, tr("Color"), tr("Color of the selected channel"));
    setFieldText(style, m_scale, tr("Scale"),
                 tr("Drawn as value × scale + offset; cursors show the actual value"));
    setFieldText(style, m_offset, tr("Offset"), tr("Added to the drawn value, in the same unit"));
    m_reset->setText(tr("Reset"));
    m_reset->setToolTip(tr("Shows the goal, position, speed and current of the selected servo"));
    m_close->setText(tr("Close"));
    m_close->setToolTip(tr("Closes this list and keeps the channels"));
    fill();
}
} // namespace ui
