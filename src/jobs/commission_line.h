// SPDX-License-Identifier: GPL-3.0-or-later
// The line itself: waits for servos, deals with each, keeps the batch. Lives for one call of
// commission(); internal to jobs; its thread. commission_line.cpp knows who is there,
// commission_deal.cpp what is done to a servo, commission_end.cpp what becomes of it.
#pragma once

#include "jobs/commission_look.h"
#include "jobs/commission_steps.h"

#include <map>

namespace jobs {
constexpr base::Duration answerPause = std::chrono::milliseconds(50);
/// A plug that is being pulled makes contact more than once.
constexpr int silencesUntilGone = 3;

class CommissionLine {
public:
    CommissionLine(const device::Context& context, const CommissionSpec& spec,
                   record::CommissionBatch& batch, QString csvPath, const CommissionHooks& hooks)
        : m_context(context)
        , m_spec(spec)
        , m_batch(batch)
        , m_csvPath(std::move(csvPath))
        , m_hooks(hooks)
        , m_look(context, spec)
    {}

    base::Result<CommissionEnd> run();

private:
    using Place = CommissionLook::Place;

    static Place placeOf(const record::CommissionPlace& kept);
    static Place placeOf(const device::Servo& servo);
    std::optional<int> nextId() const;
    void show(const CommissionView& view);
    base::Result<void> pause(base::Duration span);
    base::Result<void> keep();

    // --- who is there ---
    base::Result<device::Servo> awaitServo();
    base::Result<bool> alone(const Place& first, device::Servo& servo);
    std::vector<Place> expected() const;
    CommissionView waitingView() const;
    base::Result<void> awaitGone(const Place& place, CommissionView view);
    /// The row of a servo that is done with, and waits until it is unplugged.
    base::Result<void> enter(const CommissionWork& work, const record::CommissionRow& row,
                             CommissionView view);

    // --- one servo ---
    base::Result<void> deal(device::Servo servo);
    base::Result<void> setAside(const CommissionWork& work,
                                const std::vector<record::CommissionTrouble>& why);
    base::Result<bool> decide(CommissionWork& work, CommissionView& view,
                              std::vector<record::CommissionTrouble>& concerns);
    base::Result<bool> confirm(CommissionWork& work, CommissionView view,
                               std::vector<record::CommissionTrouble>& concerns);
    base::Result<void> setUp(CommissionWork& work, CommissionView& view);
    base::Result<void> begin(CommissionWork& work, CommissionView& view);
    base::Result<void> enlist(const CommissionWork& work, const CommissionView& view);
    base::Result<void> takeId(CommissionWork& work);
    base::Result<void> placed(CommissionWork& work);
    enum class Stay : std::uint8_t {
        NotProven, ///< another one may be here by now
        Settled,   ///< the very servo, and nothing of it is open any more
        Unsettled, ///< the very servo: its lock does not close, or a write is refused
    };
    base::Result<Stay> stayed(CommissionWork& work, const record::CommissionPending& begun);
    base::Result<void> failed(CommissionWork& work, const base::Error& error);
    base::Result<void> lose();
    base::Result<void> finish(CommissionWork& work);
    base::Result<void> keepName(CommissionWork& work, const QString& label);
    QString labelOf(const CommissionWork& work) const;
    base::Result<bool> stillAlone(CommissionWork& work);
    bool recognise(CommissionWork& work, CommissionView& view);
    void addUnfinished(const CommissionWork& work, CommissionView& view);
    record::CommissionPending* pendingFor(int newId, const QString& protocol);
    record::CommissionPending* pendingOf(const CommissionWork& work);

    const device::Context& m_context;
    const CommissionSpec& m_spec;
    record::CommissionBatch& m_batch;
    const QString m_csvPath;
    const CommissionHooks& m_hooks;
    CommissionLook m_look;
    std::optional<CommissionView> m_view;
    std::map<int, int> m_returns; ///< by the ID it was to have: how often it was looked at anew
    bool m_lost = false;          ///< the last one went away in the middle
};
} // namespace jobs
