// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan_twins.h"

#include "device/alarms.h"
#include "device/reader.h"
#include "device/twin_check.h"

#include <algorithm>

namespace jobs {
namespace {
using catalog::Role;

constexpr int cleanReadsWanted = 2;
constexpr int maxFailures = 5;
constexpr int brokenReadsSuspicious = 2;
constexpr base::Duration readsApart = std::chrono::milliseconds(1);

class TwinCheck {
public:
    TwinCheck(const device::Context& context, device::Servo& servo)
        : m_context(context)
        , m_servo(servo)
    {}

    base::Result<bool> run()
    {
        m_context.bus.takeStrays();
        const auto feedback = readFeedback();
        if (!feedback || *feedback || m_failures == 0)
            return feedback;
        // Something was wrong once; through a slow adapter one read more of every servo is too
        // dear.
        return readIdentity();
    }

private:
    enum class Read { Clean, Broken, Silent };

    base::Result<bool> readIdentity()
    {
        const auto spans = identitySpans();
        device::Servo again = m_servo;
        const auto clean = readUntilClean(again, spans);
        if (!clean)
            return tl::unexpected(clean.error());
        // What was not read before says nothing.
        const bool changed =
            std::any_of(spans.begin(), spans.end(), [&](const bus::PollSpan& span) {
                const auto before = m_servo.image.bytes(span.address, span.count);
                return before && again.image.bytes(span.address, span.count) != before;
            });
        return suspicious() || (*clean && changed);
    }

    /// What device::identify() reads, and what tells one servo from another.
    std::vector<bus::PollSpan> identitySpans() const
    {
        std::vector<const catalog::Register*> registers;
        for (const Role role :
             {Role::FirmwareMajor, Role::FirmwareMinor, Role::ByteOrder, Role::ModelMajor,
              Role::ModelMinor, Role::Id, Role::BaudRate, Role::ReturnDelay, Role::ResponseLevel}) {
            if (const catalog::Register* reg = m_servo.profile->byRole(role))
                registers.push_back(reg);
        }
        return device::planSpans(*m_servo.profile, registers);
    }

    base::Result<bool> readFeedback()
    {
        const auto spans = feedbackSpans();
        std::optional<device::Servo> earlier;
        base::Duration earlierAt{};
        for (int i = 0; i < cleanReadsWanted && !spans.empty(); ++i) {
            const auto clean = readUntilClean(m_servo, spans);
            if (!clean)
                return tl::unexpected(clean.error());
            if (suspicious())
                return true;
            if (!*clean)
                break;
            const base::Duration now = m_context.bus.clock().now();
            if (earlier && !device::couldBeOneServo(*earlier, m_servo, now - earlierAt))
                return true;
            earlier = m_servo;
            earlierAt = now;
        }
        return false;
    }

    std::vector<bus::PollSpan> feedbackSpans() const
    {
        std::vector<const catalog::Register*> registers;
        for (const catalog::Register& reg : m_servo.profile->registers) {
            if (reg.area == catalog::Area::Feedback)
                registers.push_back(&reg);
        }
        return device::planSpans(*m_servo.profile, registers);
    }

    bool suspicious() const { return m_broken >= brokenReadsSuspicious || m_secondReply; }

    /// False: no clean read within the tries left, or already suspicious.
    base::Result<bool> readUntilClean(device::Servo& servo, const std::vector<bus::PollSpan>& spans)
    {
        while (m_failures < maxFailures && !suspicious()) {
            if (m_context.stop.requested())
                return base::fail(base::ErrorCode::Stopped, QStringLiteral("scan"));
            if (const auto listened = m_context.bus.listen(readsApart); !listened)
                return tl::unexpected(listened.error());
            bool allClean = true;
            for (const bus::PollSpan& span : spans) {
                const auto outcome = readOnce(servo, span);
                if (!outcome)
                    return tl::unexpected(outcome.error());
                allClean = allClean && *outcome == Read::Clean;
            }
            if (allClean)
                return !suspicious();
            ++m_failures;
        }
        return false;
    }

    base::Result<Read> readOnce(device::Servo& servo, const bus::PollSpan& span)
    {
        bus::Transaction transaction;
        transaction.request =
            protocol::Request::read(servo.id, span.address, span.count).in(servo.protocol);
        transaction.priority = m_context.priority;
        transaction.retries = 0; // a repeated read would hide what is looked for
        transaction.hold = m_context.hold;
        transaction.stop = &m_context.stop;
        const auto outcome = m_context.bus.transact(transaction);
        if (!outcome)
            return failedRead(outcome.error());
        for (const bus::Fault& fault : outcome->faults)
            m_broken += fault.kind == bus::FaultKind::BadCheck ? 1 : 0;
        const auto strays = m_context.bus.takeStrays();
        // After a time-out a stray is the late reply to the read before.
        m_secondReply =
            m_secondReply ||
            (!m_timedOut && std::any_of(strays.begin(), strays.end(), [&](const bus::Stray& stray) {
                return stray.id == servo.id;
            }));
        if (servo.repliesCarryStatus())
            servo.status = outcome->status();
        servo.image.store(span.address, outcome->data(), outcome->sentAt + outcome->roundTrip);
        device::takeStatus(servo, span.address, span.count);
        return Read::Clean;
    }

    base::Result<Read> failedRead(const base::Error& error)
    {
        switch (error.code) {
        case base::ErrorCode::Garbled:
        case base::ErrorCode::WrongAnswer:
            ++m_broken;
            return Read::Broken;
        case base::ErrorCode::Refused: // a Modbus station without this register
        case base::ErrorCode::NoAnswer:
            m_timedOut = true;
            return Read::Silent;
        default:
            return tl::unexpected(error);
        }
    }

    const device::Context& m_context;
    device::Servo& m_servo;
    int m_failures = 0;
    int m_broken = 0;
    bool m_timedOut = false;
    bool m_secondReply = false;
};

} // namespace

base::Result<bool> suspectTwins(const device::Context& context, device::Servo& servo)
{
    return TwinCheck(context, servo).run();
}
} // namespace jobs
