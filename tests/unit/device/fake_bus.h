// SPDX-License-Identifier: GPL-3.0-or-later
// A fake bus: executes requests on fake servos at once, in the protocol of each request, and loses,
// refuses or cuts what the test selects. Errors are those of a real bus. The codecs still check
// every request, so nothing passes here that has no bytes. Single thread.
#pragma once

#include "bus/bus.h"
#include "device/context.h"
#include "device/reader.h"
#include "protocol/codec.h"

#include "fake_servo.h"
#include <algorithm>
#include <deque>

namespace fake {
using protocol::Op;
using protocol::Request;

class Bus final : public bus::Bus {
public:
    std::deque<Servo> servos;
    std::vector<Request> requests;    ///< every request that went out, in order
    bool dropAcknowledgments = false; ///< writes are carried out, their answers are lost
    int lostWrites = 0;               ///< number of writes that never arrive
    int ignoredWrites = 0;            ///< number of writes that are acknowledged without effect
    int cutAfter = -1;                ///< number of requests until the link is lost; −1: never
    bool bridge = false;              ///< a port without a rate of its own
    bool emergencyPending =
        false; ///< torque goes off everywhere and the request ends with Preempted
    std::function<void(const Request&)> onRequest;
    base::ManualClock time;

    int writes() const
    {
        return int(std::count_if(requests.begin(), requests.end(), [](const Request& request) {
            return request.op != Op::Ping && request.op != Op::Read;
        }));
    }

    base::Result<bus::Outcome> transact(const bus::Transaction& transaction) override
    {
        const Request& request = transaction.request;
        if (const auto frame = protocol::codecFor(request.protocol).encode(request); !frame)
            return tl::unexpected(frame.error());
        if (cutAfter == 0)
            return base::fail(base::ErrorCode::LinkLost, {}, {}, request.id);
        cutAfter -= cutAfter > 0 ? 1 : 0;
        time.advance(std::chrono::milliseconds(1));
        requests.push_back(request);
        if (onRequest)
            onRequest(request);
        if (std::exchange(emergencyPending, false)) {
            requests.pop_back();
            for (Servo& servo : servos)
                servo.poke(servo.profile->byRole(catalog::Role::TorqueSwitch)->key, 0);
            return base::fail(base::ErrorCode::Preempted, {}, {}, request.id);
        }
        return isQuestion(request) ? handleRead(request) : handleWrite(request);
    }

    base::Result<void> listen(base::Duration span) override
    {
        time.advance(span);
        return {};
    }
    std::vector<bus::UnexpectedFrame> takeUnexpectedFrames() override { return {}; }
    base::Result<void> setBaud(int baud) override
    {
        m_baud = baud;
        return {};
    }
    int baud() const override { return m_baud; }
    bool canSetBaud() const override { return !bridge; }
    QString portName() const override { return QStringLiteral("paper"); }
    bool lost() const override { return false; }
    bool isReconnecting() const override { return false; }
    void setReconnectTimeout(base::Duration) override {}
    bool hasEcho() const override { return false; }
    bool pauseUntil(base::Duration instant, const base::StopToken* stop) override
    {
        return time.sleepUntil(instant, stop);
    }
    bus::Hold hold(const std::vector<int>&, std::optional<std::uint64_t>) override
    {
        return {this, ++m_token};
    }
    std::uint64_t emergencyCount() const override { return 0; }
    bus::PollId startPoll(const bus::PollPlan&) override { return 0; }
    void stopPoll(bus::PollId) override {}
    std::vector<bus::Sample> takeSamples(bus::PollId) override { return {}; }
    void setStopFrames(std::vector<bus::StopFrame>) override {}
    void emergency() override {}
    void setRetries(int) override {}
    void setTimeout(base::Duration) override {}
    base::Duration maxReplyLateness() const override { return std::chrono::milliseconds(25); }
    void setReplyDelay(base::Duration) override {}
    void setSilence(base::Duration) override {}
    bus::Statistics statistics() const override { return {}; }
    std::uint64_t unsolicitedNoise() const override { return 0; }
    std::vector<bus::TraceEntry> takeTrace() override { return {}; }
    base::Clock& clock() const override { return const_cast<base::ManualClock&>(time); }

protected:
    void release(std::uint64_t) override {}

private:
    using Outcome = base::Result<bus::Outcome>;

    static bool isQuestion(const Request& request)
    {
        return request.op == Op::Ping || request.op == Op::Read;
    }
    static bool isBroadcast(const Request& request) { return request.id == protocol::broadcastId; }

    std::vector<Servo*> addressed(const Request& request)
    {
        std::vector<Servo*> found;
        for (Servo& servo : servos) {
            const bool isAddressed = servo.profile->protocol == request.protocol &&
                                     servo.baud == m_baud &&
                                     (servo.id == request.id || isBroadcast(request));
            if (!isAddressed)
                continue;
            if (servo.requestsUntilReady > 0)
                --servo.requestsUntilReady;
            else
                found.push_back(&servo);
        }
        return found;
    }

    Outcome failed(const Request& request, base::ErrorCode code, const QString& detail = {}) const
    {
        base::Error error{code, QStringLiteral("bus"), detail, request.id};
        if (request.repeat == protocol::Repeat::Never && code == base::ErrorCode::NoReply)
            error.code = base::ErrorCode::Uncertain;
        return tl::unexpected(error);
    }

    Outcome answered(const Request& request, const Servo& servo, base::Bytes data) const
    {
        const bool level = servo.profile->protocol == base::Protocol::Feetech;
        bus::Outcome outcome;
        outcome.attempts = 1;
        outcome.sentAt = time.now();
        outcome.replies.push_back(
            {request.id, level ? servo.status : std::uint8_t{0}, std::move(data)});
        return outcome;
    }

    Outcome handleRead(const Request& request)
    {
        const auto addressedServos = addressed(request);
        if (addressedServos.empty() ||
            (request.op == Op::Read && isSilentRead(*addressedServos.front(), request)))
            return failed(request, base::ErrorCode::NoReply);
        base::Bytes data;
        for (Servo* servo : addressedServos) {
            const base::Bytes requests = request.op == Op::Read
                                             ? servo->read(request.address, request.count)
                                             : base::Bytes{};
            if (servo != addressedServos.front() && requests != data)
                return failed(request, base::ErrorCode::Garbled);
            data = requests;
        }
        return answered(request, *addressedServos.front(), data);
    }

    /// An LX servo answers whole commands it knows.
    static bool isSilentRead(const Servo& servo, const Request& request)
    {
        if (request.protocol != base::Protocol::Lx)
            return false;
        const catalog::Register* reg = servo.profile->at(request.address);
        const bool stored = reg != nullptr && reg->role == catalog::Role::StoredGoal;
        return reg == nullptr || !reg->block || reg->block->offset != request.address ||
               reg->block->size != request.count || (stored && !servo.repliesStoredMove);
    }

    Outcome handleWrite(const Request& request)
    {
        if (lostWrites > 0) {
            --lostWrites;
            return unanswered(request) ? Outcome(bus::Outcome{})
                                       : failed(request, base::ErrorCode::NoReply);
        }
        const bool ignored = ignoredWrites > 0;
        ignoredWrites -= ignored ? 1 : 0;
        const auto addressedServos = addressed(request);
        for (Servo* servo : addressedServos) {
            if (ignored)
                continue;
            if (const auto reason = servo->exceptions.find(request.address);
                reason != servo->exceptions.end())
                return failed(request, base::ErrorCode::Refused, exceptionName(reason->second));
            carryOut(*servo, request);
        }
        if (unanswered(request))
            return bus::Outcome{};
        if (addressedServos.empty() || dropAcknowledgments)
            return failed(request, base::ErrorCode::NoReply);
        return answered(request, *addressedServos.front(), {});
    }

    static bool unanswered(const Request& request)
    {
        return isBroadcast(request) || !request.acknowledged || request.op == Op::Reboot ||
               request.op == Op::SyncWrite || request.protocol == base::Protocol::Lx;
    }
    static QString exceptionName(int reason)
    {
        return reason == 2 ? QStringLiteral("illegal-address") : QStringLiteral("illegal-value");
    }

    void carryOut(Servo& servo, const Request& request)
    {
        using catalog::Role;
        switch (request.op) {
        case Op::Write:
            servo.write(request.address, request.data);
            break;
        case Op::RegWrite:
            m_held[&servo] = {request.address, request.data};
            servo.poke(servo.profile->byRole(Role::AsyncFlag)->key, 1);
            break;
        case Op::SyncWrite:
            for (const protocol::Target& target : request.targets) {
                if (target.id == servo.id)
                    servo.write(request.address, target.data);
            }
            break;
        case Op::Action:
            if (const auto held = m_held.find(&servo); held != m_held.end()) {
                servo.write(held->second.first, held->second.second);
                servo.poke(servo.profile->byRole(Role::AsyncFlag)->key, 0);
                m_held.erase(held);
            }
            break;
        case Op::Calibrate:
            servo.center();
            break;
        case Op::Reboot:
            servo.powerCycle();
            servo.requestsUntilReady = 3;
            break;
        default:
            break;
        }
    }

    int m_baud = 115'200;
    std::uint64_t m_token = 0;
    std::map<Servo*, std::pair<int, base::Bytes>> m_held;
};

/// Keeps its entries, and can refuse.
class Journal final : public base::Journal {
public:
    base::Result<QString> begin(const base::Intent& intent) override
    {
        base::JournalEntry entry{intent, {}};
        entry.intent.uuid = QString::number(list.size());
        list.push_back(entry);
        return entry.intent.uuid;
    }
    base::Result<void> end(const QString& uuid, const base::IntentResult& end) override
    {
        list[uuid.toULong()].end = end;
        return {};
    }
    base::Result<std::vector<base::JournalEntry>> entries() const override { return list; }
    base::Result<void> saveServoValues(const base::ServoIdentity&, const QString& name,
                                       const std::vector<std::int64_t>& values) override
    {
        facts[name] = values;
        return {};
    }
    base::Result<std::optional<std::vector<std::int64_t>>>
    servoValues(const base::ServoIdentity&, const QString& name) const override
    {
        const auto found = facts.find(name);
        return found == facts.end() ? std::nullopt : std::optional(found->second);
    }

    std::vector<base::JournalEntry> list;
    std::map<QString, std::vector<std::int64_t>> facts;
};

/// A bus, a journal, and the rest of the context of an operation.
struct DeviceFixture {
    Bus bus;
    Journal journal;
    base::StopToken stop;
    device::Notices notices;

    explicit DeviceFixture(std::initializer_list<std::pair<const char*, int>> servos)
    {
        for (const auto& [family, id] : servos)
            bus.servos.emplace_back(QString::fromLatin1(family), id);
    }
    explicit DeviceFixture(const QString& family, int id = 1)
    {
        bus.servos.emplace_back(family, id);
    }

    device::Context context() { return {bus, models(), journal, stop, notices}; }
    Servo& fake(std::size_t index = 0) { return bus.servos[index]; }
    /// As the program knows it after reading its settings.
    device::Servo servo(std::size_t index = 0)
    {
        const Servo& there = fake(index);
        auto found = device::identify(context(), there.id, there.profile->protocol);
        if (!found || !device::readSettings(context(), *found))
            qFatal("servo %d does not answer", there.id);
        // The check for a second servo has been done (tst_write_duplicate_id tests it).
        bus.verifiedIds().add(found->protocol, found->id, bus.baud());
        bus.requests.clear();
        notices.clear();
        return *found;
    }
    int noticeCount(device::NoticeCode code) const
    {
        return int(std::count_if(notices.begin(), notices.end(),
                                 [code](const device::Notice& n) { return n.code == code; }));
    }
    std::size_t openIntents() const { return journal.open()->size(); }
};
} // namespace fake
