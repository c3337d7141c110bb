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
using session::ServoEntry;
using text::translate;

namespace {
constexpr std::size_t proposals = 5;
constexpr int maxProbedIds = 24; ///< maximum number of IDs tried for them
constexpr int listHeight = 168;
constexpr int idRole = Qt::UserRole;

const catalog::Register* idRegister(const ServoEntry& entry)
{
    return entry.servo.profile ? entry.servo.profile->byRole(Role::Id) : nullptr;
}
} // namespace

SetIdDialog::SetIdDialog(session::Workbench& workbench, session::ServoRef servo, QWidget* parent)
    : TaskDialog(workbench, servo, "setIdDialog", parent)
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
    finishSetup();
    findFreeIds();
    m_id->setFocus();
    m_id->selectAll();
}

/// Another servo at the same baud rate, in any protocol.
const ServoEntry* SetIdDialog::servoWithId(int id) const
{
    for (const session::ServoRef ref : workbench().registry().order()) {
        const ServoEntry* other = workbench().registry().servo(ref);
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
    for (const session::ServoRef ref : workbench().registry().order()) {
        const ServoEntry* other = workbench().registry().servo(ref);
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
        m_state->setText(translate("ServoTasks", "The servo already has this ID."));
    else if (holder != nullptr)
        m_state->setText(translate("ServoTasks",
                                   "ID %1 belongs to another servo (%2). Two servos with the same "
                                   "ID reply at the same time, so neither reply can be read.")
                             .arg(id)
                             .arg(modelName(*holder)));
    else
        m_state->setText(
            translate(
                "ServoTasks",
                "ServoDesk first checks ID %1 and writes it only if no servo replies with this ID.")
                .arg(id));
    setReady(!own && holder == nullptr);
}

void SetIdDialog::retranslate()
{
    setTexts(
        translate("ServoTasks", "Set ID"),
        translate("ServoTasks",
                  "The servo uses the new ID immediately and keeps it after power-off. ServoDesk "
                  "switches automatically; other programs must be set to the new ID."),
        translate("ServoTasks", "Set ID"),
        translate(
            "ServoTasks",
            "Checks that the new ID is free, writes it, and locks the EPROM using the new ID"));
    m_label->setText(translate("ServoTasks", "New ID:"));
    m_id->setAccessibleName(translate("ServoTasks", "New ID"));
    m_id->setToolTip(
        translate("ServoTasks", "The new ID, %1 to %2").arg(m_id->minimum()).arg(m_id->maximum()));
    m_list->setAccessibleName(translate("ServoTasks", "IDs on this bus"));
    m_list->setToolTip(translate("ServoTasks", "Used and free IDs; select a free one"));
}

void SetIdDialog::refresh()
{
    fillList();
    validate();
}

void SetIdDialog::runAction()
{
    if (const catalog::Register* reg = idRegister(*entry()))
        writeRegister(*reg, m_id->value(),
                      QT_TRANSLATE_NOOP("ServoTasks", "The ID has been changed."));
}
} // namespace ui
