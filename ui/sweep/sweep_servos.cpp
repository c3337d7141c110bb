// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/sweep_servos.h"

#include "report/sweep_text.h"
#include "text/language.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/widgets/test_text.h"
#include "ui/widgets/tone_delegate.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace ui {
namespace {
enum Column { Servo, Start, End, Verdicts, ColumnCount };
constexpr int maxVisibleRows = 6; ///< the servos of a common arm

/// It takes the room that is left, but asks for its minimum only.
class ServoTable final : public QTableWidget {
public:
    using QTableWidget::QTableWidget;
    QSize sizeHint() const override { return {QTableWidget::sizeHint().width(), minimumHeight()}; }
};

QString limitsKey(const QString& model)
{
    return QStringLiteral("sweep/limits/") + model;
}

bool isTestable(const session::ServoEntry* entry)
{
    return entry != nullptr && entry->servo.profile && entry->servo.profile->writable;
}
} // namespace

SweepServos::SweepServos(session::ServoRegistry& registry, Selection& selection,
                         session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_registry(registry)
    , m_selection(selection)
    , m_settings(settings)
    , m_title(new QLabel(this))
    , m_table(new ServoTable(0, ColumnCount, this))
    , m_limitsName(new QLabel(this))
    , m_limits(new QPushButton(this))
    , m_editTriggers(m_table->editTriggers())
{
    m_table->setObjectName(QStringLiteral("sweepServos"));
    styleTable(m_table);
    fitHeight();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    for (const int column : {Servo, Verdicts})
        m_table->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setItemDelegateForColumn(Verdicts, new ToneDelegate(m_table));
    m_table->setColumnHidden(Verdicts, true);
    m_limits->setObjectName(QStringLiteral("sweepLimits"));
    m_limitsName->setObjectName(QStringLiteral("sweepLimitsName"));
    m_limitsName->setForegroundRole(QPalette::PlaceholderText);
    m_limitsName->setWordWrap(true);
    auto* limits = new QHBoxLayout;
    limits->addWidget(m_limitsName, 1);
    limits->addWidget(m_limits);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(4);
    column->addWidget(m_title);
    column->addWidget(m_table);
    column->addLayout(limits);
    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(0);
    connect(&m_rebuild, &QTimer::timeout, this, &SweepServos::rebuild);
    const auto again = [this] { m_rebuild.start(); };
    connect(&registry, &session::ServoRegistry::servoAdded, this, again);
    connect(&registry, &session::ServoRegistry::servoRemoved, this, again);
    connect(&registry, &session::ServoRegistry::servosCleared, this, again);
    connect(&registry, &session::ServoRegistry::orderChanged, this, again);
    connect(&selection, &Selection::selectedServosChanged, this, &SweepServos::followSelection);
    connect(m_table, &QTableWidget::itemChanged, this, &SweepServos::onItemEdited);
    connect(m_table, &QTableWidget::currentCellChanged, this, &SweepServos::showLimits);
    connect(m_table, &QTableWidget::cellClicked, this, [this](int row) {
        if (const auto ref = refAt(row))
            Q_EMIT clicked(ref);
    });
    connect(m_limits, &QPushButton::clicked, this, [this] {
        if (const auto ref = refAt(std::max(0, m_table->currentRow())))
            Q_EMIT limitsRequested(ref);
    });
    followLanguage(this, [this] { retranslate(); });
    followSelection();
    showLimits(); // of none, until the rows are there
}

session::ServoRef SweepServos::refAt(int row) const
{
    const QTableWidgetItem* item = m_table->item(row, Servo);
    return item != nullptr ? item->data(Qt::UserRole).toInt() : 0;
}

/// Fits the table to its rows, so that the rest of the form gets more room.
void SweepServos::fitHeight()
{
    const int rows = std::clamp(m_table->rowCount(), 1, maxVisibleRows);
    m_table->setMinimumHeight(m_table->horizontalHeader()->sizeHint().height() +
                              rows * m_table->verticalHeader()->defaultSectionSize() +
                              2 * m_table->frameWidth());
}

void SweepServos::rebuild()
{
    const session::ServoRef current = refAt(m_table->currentRow());
    m_filling = true;
    m_table->clearContents();
    std::vector<const session::ServoEntry*> shown;
    for (const session::ServoRef ref : m_registry.order()) {
        if (const session::ServoEntry* entry = m_registry.servo(ref); isTestable(entry))
            shown.push_back(entry);
    }
    m_table->setRowCount(int(shown.size()));
    fitHeight();
    int row = 0;
    for (const session::ServoEntry* entry : shown) {
        fillRow(row, *entry);
        if (entry->ref == current || (current == 0 && m_ticked.count(entry->ref) != 0))
            m_table->setCurrentCell(row, Servo);
        ++row;
    }
    m_filling = false;
    showVerdicts();
    const auto gone = [this](const auto& one) { return m_registry.servo(one) == nullptr; };
    const std::size_t before = m_ticked.size();
    std::erase_if(m_ticked, gone);
    if (m_ticked.empty() && std::exchange(m_userSelected, false))
        followSelection();
    std::erase_if(m_ranges, [&](const auto& one) { return gone(one.first); });
    showLimits();
    if (before != m_ticked.size())
        Q_EMIT changed();
}

void SweepServos::fillRow(int row, const session::ServoEntry& entry)
{
    auto* servo = new QTableWidgetItem(
        QStringLiteral("%1 · %2").arg(entry.servo.id).arg(entry.servo.profile->modelName));
    servo->setData(Qt::UserRole, entry.ref);
    servo->setFlags(servoFlags());
    servo->setCheckState(m_ticked.count(entry.ref) != 0 ? Qt::Checked : Qt::Unchecked);
    servo->setToolTip(tr("Select the servo to include it in the test"));
    const auto own = m_ranges.find(entry.ref);
    const results::SweepRange range = own != m_ranges.end() ? own->second : results::SweepRange{};
    const QString tip = tr("Range of this servo; leave empty to use the start and end above");
    auto* from = new QTableWidgetItem(range.from);
    auto* to = new QTableWidgetItem(range.to);
    from->setToolTip(tip);
    to->setToolTip(tip);
    m_table->setItem(row, Servo, servo);
    m_table->setItem(row, Start, from);
    m_table->setItem(row, End, to);
    auto* verdict = new QTableWidgetItem;
    verdict->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    m_table->setItem(row, Verdicts, verdict);
}

void SweepServos::setVerdicts(const std::map<session::ServoRef, Verdict>& verdicts)
{
    m_verdicts = verdicts;
    showVerdicts();
}

void SweepServos::showVerdicts()
{
    m_filling = true;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        QTableWidgetItem* item = m_table->item(row, Verdicts);
        const auto found = m_verdicts.find(refAt(row));
        if (item == nullptr)
            continue;
        const bool known = found != m_verdicts.end();
        item->setText(known ? gradeText(found->second.grade) : QString());
        item->setToolTip(known ? found->second.text : QString());
        item->setData(toneRole, known ? QVariant(int(gradeTone(found->second.grade))) : QVariant());
    }
    m_filling = false;
    m_table->setColumnHidden(Verdicts, m_verdicts.empty());
}

void SweepServos::markRow(session::ServoRef ref)
{
    for (int row = 0; row < m_table->rowCount(); ++row) {
        if (refAt(row) == ref && m_table->currentRow() != row)
            m_table->setCurrentCell(row, Servo);
    }
}

Qt::ItemFlags SweepServos::servoFlags() const
{
    const Qt::ItemFlags always = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return m_locked ? always : always | Qt::ItemIsUserCheckable;
}

void SweepServos::setLocked(bool locked)
{
    if (locked == m_locked)
        return;
    m_locked = locked;
    m_table->setEditTriggers(locked ? QAbstractItemView::NoEditTriggers : m_editTriggers);
    m_filling = true;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        if (QTableWidgetItem* servo = m_table->item(row, Servo))
            servo->setFlags(servoFlags());
    }
    m_filling = false;
    showLimits();
}

void SweepServos::onItemEdited(QTableWidgetItem* item)
{
    const session::ServoRef ref = refAt(item->row());
    if (m_filling || ref == 0)
        return;
    if (item->column() == Verdicts)
        return;
    if (item->column() == Servo) {
        if (item->checkState() == Qt::Checked)
            m_ticked.insert(ref);
        else
            m_ticked.erase(ref);
        m_userSelected = !m_ticked.empty();
    } else {
        results::SweepRange& range = m_ranges[ref];
        (item->column() == Start ? range.from : range.to) = item->text().trimmed();
    }
    Q_EMIT changed();
}

/// The user's own ticks stay, whatever is selected elsewhere, until the last tick is gone.
void SweepServos::followSelection()
{
    if (m_userSelected)
        return;
    const auto& chosen = m_selection.selected();
    m_ticked = {chosen.begin(), chosen.end()};
    m_rebuild.start();
    Q_EMIT changed();
}

std::vector<session::ServoRef> SweepServos::selected() const
{
    std::vector<session::ServoRef> refs;
    for (const session::ServoRef ref : m_registry.order()) {
        if (m_ticked.count(ref) != 0 && isTestable(m_registry.servo(ref)))
            refs.push_back(ref);
    }
    return refs;
}

std::map<int, results::SweepRange> SweepServos::ranges() const
{
    std::map<int, results::SweepRange> ranges;
    for (const session::ServoRef ref : selected()) {
        const auto own = m_ranges.find(ref);
        if (own != m_ranges.end() && !(own->second.from.isEmpty() && own->second.to.isEmpty()))
            ranges[m_registry.servo(ref)->servo.id] = own->second;
    }
    return ranges;
}

const std::optional<results::SweepLimits>& SweepServos::ownLimits(const QString& model) const
{
    const auto known = m_modelLimits.find(model);
    if (known != m_modelLimits.end())
        return known->second;
    const QByteArray kept = m_settings.pageValue(limitsKey(model), QString()).toString().toUtf8();
    std::optional<results::SweepLimits> own;
    if (const auto read = results::decodeSweepLimits(kept); !kept.isEmpty() && read)
        own = results::withNameOfItsOwn(*read, model);
    return m_modelLimits[model] = own;
}

results::SweepLimits SweepServos::limits(session::ServoRef ref) const
{
    const session::ServoEntry* entry = m_registry.servo(ref);
    if (!isTestable(entry))
        return {};
    const auto& profile = *entry->servo.profile;
    return ownLimits(profile.modelName)
        .value_or(results::builtInSweepLimits(profile.modelName, profile.series));
}

void SweepServos::setLimits(const QString& model, const QString& series,
                            const results::SweepLimits& limits)
{
    const bool own = !(limits == results::builtInSweepLimits(model, series));
    m_modelLimits[model] = own ? std::optional(limits) : std::nullopt;
    m_settings.setPageValue(
        limitsKey(model), own ? QString::fromUtf8(results::encodeSweepLimits(limits)) : QString());
    showLimits();
    Q_EMIT changed();
}

void SweepServos::showLimits()
{
    const session::ServoRef ref = refAt(std::max(0, m_table->currentRow()));
    m_limits->setEnabled(ref != 0 && !m_locked);
    const session::ServoEntry* entry = m_registry.servo(ref);
    if (ref == 0 || entry == nullptr) {
        m_limitsName->clear();
        return;
    }
    const bool own = ownLimits(entry->servo.profile->modelName).has_value();
    m_limitsName->setText(
        own ? tr("Limits: %1").arg(text::localized(report::limitsName(limits(ref).name)))
            : tr("Limits: built-in"));
}

void SweepServos::retranslate()
{
    m_title->setText(tr("Servos"));
    m_table->setAccessibleName(tr("Servos to test"));
    m_table->setHorizontalHeaderLabels({tr("Servo"), tr("Start"), tr("End"), tr("Verdict")});
    m_table->setToolTip(
        tr("Select the servos to test; enter individual start and end values where needed"));
    m_limits->setText(tr("Limits…"));
    m_limits->setAccessibleName(m_limits->text());
    m_limits->setToolTip(
        tr("Shows, edits, loads and saves the limits for the servo in the selected row"));
    m_rebuild.start();
}
} // namespace ui
