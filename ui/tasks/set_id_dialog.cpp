// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/set_id_dialog.h"

#include "jobs/scan/find_free_ids.h"
#include "text/translate.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QSpinBox>

#include <algorithm>
#include <set>

namespace ui {
using catalog::Role;
using session::Event;
using session::ServoEntry;
using text::translate;

namespace {
constexpr std::size_t proposals = 5;
constexpr int maxProbedIds = 24; ///< IDs looked at for them, at most
constexpr int listHeight = 168;
constexpr int idRole = Qt::UserRole;

const catalog::Register* idRegister(const ServoEntry& entry)
{
    return entry.servo.profile ? entry.servo.profile->byRole(Role::Id) : nullptr;
}
} // namespace

SetIdDialog::SetIdDialog(session::Desk& desk, session::ServoRef servo, QWidget* parent)
    : TaskDialog(desk, servo, "setIdDialog", parent)
    , m_label(new QLabel(this))
    , m_id(new QSpinBox(this))
    , m_list(new QListWidget(this))
    , m_state(textLabel("idState"))
{
    constexpr int lastId = 253;
    const catalog::Register* reg = idRegister(*entry());
    m_id->setObjectName(QStringLiteral("newId"));
    m_id->setRange(reg != nullptr ? static_cast<int>(reg->min.value_or(0)) : 0,
                   reg != nullptr ? static_cast<int>(reg->max.value_or(lastId)) : lastId);
    m_id->setValue(entry()->servo.id);
    m_label->setBuddy(m_id);
    m_list->setObjectName(QStringLiteral("idList"));
    m_list->setFixedHeight(listHeight);
    m_list->setUniformItemSizes(true);
    auto* row = new QHBoxLayout;
    row->addWidget(m_label);
    row->addWidget(m_id);
    row->addStretch();
    body()->addLayout(row);
    body()->addWidget(m_list);
    body()->addWidget(m_state);
    connect(m_id, &QSpinBox::valueChanged, this, [this] {
        m_chosenByUser = true;
        validate();
    });
    connect(m_list, &QListWidget::currentItemChanged, this,
            [this](QListWidgetItem* item) { selectId(item); });
    connect(m_list, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { selectId(item); });
    connect(&desk, &session::Desk::eventOccurred, this, &SetIdDialog::onDeskEvent);
    finishSetup();
    findFreeIds();
    m_id->setFocus();
    m_id->selectAll();
}

/// Of another servo at the same rate, whatever it speaks.
const ServoEntry* SetIdDialog::servoWithId(int id) const
{
    for (const session::ServoRef ref : desk().servos()) {
        const ServoEntry* other = desk().servo(ref);
        if (ref != servo() && other->servo.id == id && other->servo.baud == entry()->servo.baud)
            return other;
    }
    return nullptr;
}

void SetIdDialog::findFreeIds()
{
    std::vector<int> candidates;
    for (int id = std::max(m_id->minimum(), 1);
         id <= m_id->maximum() && static_cast<int>(candidates.size()) < maxProbedIds; ++id) {
        if (id != entry()->servo.id && servoWithId(id) == nullptr)
            candidates.push_back(id);
    }
    const auto found = std::make_shared<std::vector<int>>();
    session::Task task;
    task.name = QStringLiteral("free-ids");
    task.work = [candidates, found](session::TaskContext& context) -> base::Result<void> {
        const auto free =
            jobs::findFreeIds(context.device, context.servo.protocol, candidates, proposals);
        if (!free)
            return tl::unexpected(free.error());
        *found = *free;
        return {};
    };
    runInBackground(std::move(task), [this, found](const session::TaskCompletion&) {
        m_free = *found;
        if (!m_chosenByUser && !m_free.empty()) {
            m_id->setValue(m_free.front());
            m_id->selectAll();
        }
        fillList();
        validate();
    });
}

void SetIdDialog::fillList()
{
    struct Row {
        QString text;
        bool free = false;
    };
    std::map<int, Row> rows;
    for (const int id : m_free) {
        if (id != entry()->servo.id && servoWithId(id) == nullptr)
            rows[id] = {translate("ServoTasks", "%1 — free").arg(id), true};
    }
    for (const session::ServoRef ref : desk().servos()) {
        const ServoEntry* other = desk().servo(ref);
        if (other->servo.baud != entry()->servo.baud)
            continue;
        const QString line = ref == servo() ? translate("ServoTasks", "%1 — this servo (%2)")
                                            : translate("ServoTasks", "%1 — taken by %2");
        rows[other->servo.id] = {line.arg(other->servo.id).arg(modelName(*other)), false};
    }
    const QSignalBlocker blocker(m_list);
    m_list->clear();
    for (const auto& [id, row] : rows) {
        auto* item = new QListWidgetItem(row.text, m_list);
        item->setData(idRole, id);
        item->setToolTip(row.text);
        if (!row.free)
            item->setFlags(Qt::ItemIsEnabled);
    }
}

void SetIdDialog::selectId(const QListWidgetItem* item)
{
    if (item != nullptr && (item->flags() & Qt::ItemIsSelectable) != 0)
        m_id->setValue(item->data(idRole).toInt());
}

void SetIdDialog::validate()
{
    const int id = m_id->value();
    const ServoEntry* holder = servoWithId(id);
    const bool own = id == entry()->servo.id;
    if (own)
        m_state->setText(translate("ServoTasks", "It has this ID now."));
    else if (holder != nullptr)
        m_state->setText(translate("ServoTasks", "ID %1 belongs to another servo (%2). Two servos "
                                                 "with one ID answer at the same time, and nobody "
                                                 "is understood.")
                             .arg(id)
                             .arg(modelName(*holder)));
    else
        m_state->setText(translate("ServoTasks", "ID %1 is asked first: it is written only if "
                                                 "nobody answers to it.")
                             .arg(id));
    setReady(!own && holder == nullptr);
}

void SetIdDialog::retranslate()
{
    setTexts(translate("ServoTasks", "Set ID"),
             translate("ServoTasks", "The servo answers under the new ID at once and keeps it at "
                                     "power-off. ServoDesk follows it; other programs have to be "
                                     "told."),
             translate("ServoTasks", "Set ID"),
             translate("ServoTasks", "Prove the ID free, write it, and close the lock there"));
    m_label->setText(translate("ServoTasks", "New ID:"));
    m_id->setAccessibleName(translate("ServoTasks", "New ID"));
    m_id->setToolTip(
        translate("ServoTasks", "The new ID, %1 to %2").arg(m_id->minimum()).arg(m_id->maximum()));
    m_list->setAccessibleName(translate("ServoTasks", "IDs on this bus"));
    m_list->setToolTip(
        translate("ServoTasks", "Who has which ID, and free ones; choose a free one"));
}

void SetIdDialog::refresh()
{
    fillList();
    validate();
}

void SetIdDialog::runAction()
{
    const catalog::Register* reg = idRegister(*entry());
    if (reg == nullptr)
        return;
    m_pendingId = m_id->value();
    setRunning(true);
    session::WriteRequest order;
    order.items = {{reg->key, m_pendingId}};
    order.dangerous = true; // this dialog is the question
    desk().write(servo(), order);
}

/// Writes have no callback: ours has ended when no write of the ID is pending any more.
void SetIdDialog::onDeskEvent(const Event& event)
{
    const ServoEntry* own = entry();
    if (m_pendingId < 0 || event.kind != Event::Kind::Written || event.servo != servo() ||
        own == nullptr)
        return;
    const auto row = own->writes.find(idRegister(*own)->key);
    if (row != own->writes.end() && row->second.pending > 0)
        return;
    m_pendingId = -1;
    setRunning(false);
    refresh();
    if (event.error)
        showError(*event.error);
    if (!event.report)
        return;
    showResult([this, report = *event.report, notices = event.notices] {
        TaskText result =
            writeText(*entry(), report, translate("ServoTasks", "The ID has been changed."));
        result.details += noticeLines(notices);
        return result;
    });
}
} // namespace ui
