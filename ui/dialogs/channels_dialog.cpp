// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/channels_dialog.h"

#include "catalog/units.h"
#include "text/language.h"

#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QEvent>
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
constexpr double mostScale = 1e6;
} // namespace

ChannelsDialog::ChannelsDialog(const session::Desk& desk, std::vector<TrendChoice> choices,
                               QWidget* parent)
    : QDialog(parent)
    , m_desk(desk)
    , m_choices(std::move(choices))
{
    setObjectName(QStringLiteral("channelsDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    retranslate();
    resize(460, 560);
    connect(&desk, &session::Desk::servoAdded, this, &ChannelsDialog::fill);
    connect(&desk, &session::Desk::servoRemoved, this, &ChannelsDialog::fill);
    connect(&desk, &session::Desk::servosCleared, this, &ChannelsDialog::fill);
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
    auto* look = new QFormLayout;
    m_colour = new QPushButton(this);
    m_colour->setObjectName(QStringLiteral("channelColour"));
    const auto number = [this](const char* name) {
        auto* box = new QDoubleSpinBox(this);
        box->setObjectName(QString::fromLatin1(name));
        box->setRange(-mostScale, mostScale);
        box->setDecimals(3);
        connect(box, &QDoubleSpinBox::valueChanged, this, &ChannelsDialog::applyLook);
        return box;
    };
    m_scale = number("channelScale");
    m_offset = number("channelOffset");
    look->addRow(new QLabel(this), m_colour);
    look->addRow(new QLabel(this), m_scale);
    look->addRow(new QLabel(this), m_offset);
    for (QWidget* field : std::initializer_list<QWidget*>{m_colour, m_scale, m_offset})
        static_cast<QLabel*>(look->labelForField(field))->setBuddy(field);
    auto* buttons = new QHBoxLayout;
    m_usual = new QPushButton(this);
    m_usual->setObjectName(QStringLiteral("channelUsual"));
    m_usual->setAutoDefault(false);
    m_close = new QPushButton(this);
    m_close->setObjectName(QStringLiteral("channelClose"));
    m_close->setAutoDefault(false);
    buttons->addWidget(m_usual);
    buttons->addStretch();
    buttons->addWidget(m_close);
    column->addWidget(m_find);
    column->addWidget(m_tree, 1);
    column->addLayout(look);
    column->addLayout(buttons);
    m_colour->setAutoDefault(false);
    connect(m_find, &QLineEdit::textChanged, this, &ChannelsDialog::filter);
    connect(m_tree, &QTreeWidget::itemChanged, this, &ChannelsDialog::tick);
    connect(m_tree, &QTreeWidget::currentItemChanged, this, &ChannelsDialog::showLook);
    connect(m_colour, &QPushButton::clicked, this, &ChannelsDialog::pickColour);
    connect(m_close, &QPushButton::clicked, this, &QDialog::close);
    connect(m_usual, &QPushButton::clicked, this, [this] {
        setChoices(defaultChoices());
        Q_EMIT chosen(m_choices);
    });
}

void ChannelsDialog::setChoices(std::vector<TrendChoice> choices)
{
    m_choices = std::move(choices);
    fill();
}

TrendChoice* ChannelsDialog::choice(const QString& id)
{
    const auto found = std::find_if(m_choices.begin(), m_choices.end(),
                                    [&](const TrendChoice& one) { return one.id() == id; });
    return found != m_choices.end() ? &*found : nullptr;
}

TrendChoice* ChannelsDialog::current()
{
    const QTreeWidgetItem* item = m_tree->currentItem();
    return item != nullptr ? choice(item->data(nameColumn, idRole).toString()) : nullptr;
}

QTreeWidgetItem* ChannelsDialog::addRow(QTreeWidgetItem* parent, const QString& id,
                                        const QString& name, const QString& unit)
{
    auto* row = new QTreeWidgetItem(parent, {name, unit});
    row->setData(nameColumn, idRole, id);
    row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    const TrendChoice* known = choice(id);
    row->setCheckState(nameColumn,
                       known != nullptr && known->visible ? Qt::Checked : Qt::Unchecked);
    row->setToolTip(nameColumn, name);
    return row;
}

void ChannelsDialog::addReadyMade()
{
    auto* group = new QTreeWidgetItem(m_tree, {tr("The selected servo"), QString()});
    for (const QString& key : readyMadeKeys())
        addRow(group, QStringLiteral("*/") + key, readyMadeName(key), {});
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
    addRow(group, prefix + session::errorKey, readyMadeName(QStringLiteral("@error")), {});
    for (const catalog::Register& reg : servo.profile->registers) {
        if (servo.measures(reg))
            addRow(group, prefix + reg.key, reg.name.in(text::inChinese()),
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
    addReadyMade();
    for (const session::ServoRef ref : m_desk.servos())
        addServo(*m_desk.servo(ref));
    m_filling = false;
    filter(m_find->text());
    for (QTreeWidgetItemIterator row(m_tree); *row != nullptr; ++row) {
        if (!now.isEmpty() && (*row)->data(nameColumn, idRole).toString() == now)
            m_tree->setCurrentItem(*row);
    }
    showLook();
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

void ChannelsDialog::tick(QTreeWidgetItem* item)
{
    const QString id = item->data(nameColumn, idRole).toString();
    if (m_filling || id.isEmpty())
        return;
    const bool wanted = item->checkState(nameColumn) == Qt::Checked;
    if (TrendChoice* known = choice(id))
        known->visible = wanted;
    else if (wanted)
        m_choices.push_back(TrendChoice::fromId(id));
    m_tree->setCurrentItem(item);
    showLook();
    Q_EMIT chosen(m_choices);
}

void ChannelsDialog::showLook()
{
    const TrendChoice* now = current();
    const bool shown = now != nullptr && now->visible;
    for (QWidget* field : std::initializer_list<QWidget*>{m_colour, m_scale, m_offset})
        field->setEnabled(shown);
    const QSignalBlocker quietScale(m_scale);
    const QSignalBlocker quietOffset(m_offset);
    m_scale->setValue(shown ? now->scale : 1);
    m_offset->setValue(shown ? now->offset : 0);
    QPixmap swatch(16, 16);
    swatch.fill(shown && now->colour.isValid() ? now->colour : QColor(Qt::transparent));
    m_colour->setIcon(QIcon(swatch));
    m_colour->setText(shown && now->colour.isValid() ? now->colour.name() : tr("by its place"));
}

void ChannelsDialog::applyLook()
{
    TrendChoice* now = current();
    if (now == nullptr)
        return;
    now->scale = m_scale->value() != 0 ? m_scale->value() : 1;
    now->offset = m_offset->value();
    Q_EMIT chosen(m_choices);
}

void ChannelsDialog::pickColour()
{
    const TrendChoice* now = current();
    if (now == nullptr)
        return;
    auto* dialog = new QColorDialog(now->colour.isValid() ? now->colour : Qt::blue, this);
    dialog->setObjectName(QStringLiteral("colourDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const QString id = now->id();
    connect(dialog, &QColorDialog::colorSelected, this, [this, id](const QColor& colour) {
        TrendChoice* meant = choice(id);
        if (meant == nullptr || !colour.isValid())
            return;
        meant->colour = colour;
        showLook();
        Q_EMIT chosen(m_choices);
    });
    dialog->open();
}

void ChannelsDialog::retranslate()
{
    setWindowTitle(tr("Curves"));
    m_find->setPlaceholderText(tr("Find a register"));
    m_find->setAccessibleName(tr("Find a register"));
    m_find->setToolTip(tr("Part of its name"));
    m_tree->setHeaderLabels({tr("Curve"), tr("Unit")});
    m_tree->setAccessibleName(tr("Curves"));
    m_tree->setToolTip(tr("What is ticked is read and shown"));
    auto* look = findChild<QFormLayout*>();
    const auto label = [&](QWidget* field, const QString& text, const QString& tip) {
        static_cast<QLabel*>(look->labelForField(field))->setText(text);
        field->setAccessibleName(text);
        field->setToolTip(tip);
    };
    label(m_colour, tr("Colour"), tr("The colour of the chosen curve"));
    label(m_scale, tr("Drawn times"),
          tr("The curve is drawn as value × this + offset; cursors "
             "show the value itself"));
    label(m_offset, tr("Offset"), tr("Added to the drawn value, in its unit"));
    m_usual->setText(tr("As at first"));
    m_usual->setToolTip(tr("Goal, position, speed and current of the selected servo"));
    m_close->setText(tr("Close"));
    m_close->setToolTip(tr("Close this list; the curves stay"));
    fill();
}

void ChannelsDialog::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}
} // namespace ui
