// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan/scan_duplicate_ids.h"

#include "device/alarms.h"
#include "device/duplicate_id_check.h"
#include "device/reader.h"

#include <algorithm>

namespace jobs {
namespace {
using catalog::Role;

constexpr int requiredCleanReads = 2;
constexpr int maxFailures = 5;
constexpr int suspiciousBrokenReads = 2;
constexpr base::Duration readInterval = std::chrono::milliseconds(1);

class DuplicateIdCheck {
public:
    DuplicateIdCheck(const device::Context& context, device::Servo& servo)
        : m_context(context)
        , m_servo(servo)
    {}

    base::Result<bool> run()
    {
        m_context.bus.takeUnexpectedFrames();
        const auto feedback = readFeedback();
        if (!feedback || *feedback || m_failures == 0)
            return feedback;
        // Something was wrong once. Reading every servo once more would take too long through a
        // slow adapter.
        return readIdentity();
    }

private:
    enum class ReadResult { Clean, Broken, Silent };

    base::Result<bool> readIdentity()
    {
        const auto spans = identitySpans();
        device::Servo rereadServo = m_servo;
        const auto clean = readUntilClean(rereadServo, spans);
        if (!clean)
            return tl::unexpected(clean.error());
        // A value that was not read before proves nothing.
        const bool changed =
            std::any_of(spans.begin(), spans.end(), [&](const bus::PollSpan& span) {
                const auto before = m_servo.image.bytes(span.address, span.count);
                return before && rereadServo.image.bytes(span.address, span.count) != before;
            });
        return isSuspicious() || (*clean && changed);
    }

    /// The registers of device::identify(), and those that distinguish servos.
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
        for (int i = 0; i < requiredCleanReads && !spans.empty(); ++i) {
            const auto clean = readUntilClean(m_servo, spans);
            if (!clean)
                return tl::unexpected(clean.error());
            if (isSuspicious())
                return true;
            if (!*clean)
                break;
            const base::Duration now = m_context.bus.clock().now();
            if (earlier && !device::canBeOneServo(*earlier, m_servo, now - earlierAt))
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

    bool isSuspicious() const { return m_brokenReads >= suspiciousBrokenReads || m_secondReply; }

    /// False: no clean read within the tries left, or already suspicious.
    base::Result<bool> readUntilClean(device::Servo& servo, const std::vector<bus::PollSpan>& spans)
    {
        while (m_failures < maxFailures && !isSuspicious()) {
            if (m_context.stop.isRequested())
                return base::fail(base::ErrorCode::Stopped, QStringLiteral("scan"));
            if (const auto listened = m_context.bus.listen(readInterval); !listened)
                return tl::unexpected(listened.error());
            bool allClean = true;
            for (const bus::PollSpan& span : spans) {
                const auto outcome = readOnce(servo, span);
                if (!outcome)
                    return tl::unexpected(outcome.error());
                allClean = allClean && *outcome == ReadResult::Clean;
            }
            if (allClean)
                return !isSuspicious();
            ++m_failures;
        }
        return false;
    }

    base::Result<ReadResult> readOnce(device::Servo& servo, const bus::PollSpan& span)
    {
        bus::Transaction transaction;
        transaction.request =
            protocol::Request::read(servo.id, span.address, span.count).in(servo.protocol);
        transaction.priority = m_context.priority;
        transaction.retries = 0; // a repeated read would hide the signs
        transaction.hold = m_context.hold;
        transaction.stop = &m_context.stop;
        const auto outcome = m_context.bus.transact(transaction);
        if (!outcome)
            return failedRead(outcome.error());
        for (const bus::Fault& fault : outcome->faults)
            m_brokenReads += fault.kind == bus::FaultKind::BadChecksum ? 1 : 0;
        const auto strays = m_context.bus.takeUnexpectedFrames();
        // After a time-out a stray is the late reply to the read before.
        m_secondReply =
            m_secondReply || (!m_timedOut && std::any_of(strays.begin(), strays.end(),
                                                         [&](const bus::UnexpectedFrame& stray) {
                                                             return stray.id == servo.id;
                                                         }));
        if (servo.repliesCarryStatus())
            servo.status = outcome->status();
        servo.image.store(span.address, outcome->data(), outcome->sentAt + outcome->roundTrip);
        device::updateStatus(servo, span.address, span.count);
        return ReadResult::Clean;
    }

    base::Result<ReadResult> failedRead(const base::Error& error)
    {
        switch (error.code) {
        case base::ErrorCode::Garbled:
        case base::ErrorCode::UnexpectedReply:
            ++m_brokenReads;
            return ReadResult::Broken;
        case base::ErrorCode::Refused: // a Modbus station without this register
        case base::ErrorCode::NoReply:
            m_timedOut = true;
            return ReadResult::Silent;
        default:
            return tl::unexpected(error);
        }
    }

    const device::Context& m_context;
    device::Servo& m_servo;
    int m_failures = 0;
    int m_brokenReads = 0;
    bool m_timedOut = false;
    bool m_secondReply = false;
};

} // namespace

base::Result<bool> suspectDuplicateId(const device::Context& context, device::Servo& servo)
{
    return DuplicateIdCheck(context, servo).run();
}
} // namespace jobs
