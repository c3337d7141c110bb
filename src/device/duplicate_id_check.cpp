// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/duplicate_id_check.h"

#include "device/reader.h"

#include <algorithm>
#include <cmath>

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
/// A round reads everything that distinguishes servos once. Two good ones are enough; each sign of
/// a second servo requires two more, and the same sign a second time counts as proof.
constexpr int minGoodRounds = 2;
constexpr int minSigns = 2;
constexpr int maxRounds = 10;
constexpr int maxPasses = 4;
/// With this many unreadable replies, and more than readable ones, no retry would make a write
/// safe.
constexpr int maxBroken = 6;
/// After this many rounds in a row without a byte the servo does not answer any more.
constexpr int maxSilentRounds = 3;

// Twice the speed of the fastest servos of the vendor's list, and the jitter of a resting encoder,
// both in 1/4096 turn.
constexpr double fastestStepsPerSecond = 16'000;
constexpr double restJitterSteps = 12;
constexpr double stepsPerTurn = 4096;
constexpr double turnDegrees = 360;
constexpr double maxTemperatureJump = 3; // degrees
constexpr double maxVoltageJump = 3;     // volts: supplies sag when a motor starts
constexpr double jumpSlack = 1e-6;       // physical values are binary fractions

/// Settings that only writes can change. Values that the servo changes itself are checked for
/// jumps.
bool isConstant(const catalog::Register& reg)
{
    return reg.area == catalog::Area::Eprom || reg.area == catalog::Area::Factory;
}

/// LX servos have one command for each of these, and the whole table would take a second.
bool distinguishesServos(const catalog::Register& reg, base::Protocol protocol)
{
    if (reg.role == Role::StoredGoal || reg.role == Role::StoredTime)
        return false; // some models never answer this command
    if (protocol != base::Protocol::Lx)
        return true;
    switch (reg.role) {
    case Role::PresentPosition:
    case Role::PresentVoltage:
    case Role::PresentTemperature:
    case Role::MinAngle:
    case Role::MinVoltage:
    case Role::PositionOffset:
    case Role::TorqueSwitch:
        return true;
    default:
        return false;
    }
}

class DuplicateIdCheck {
public:
    DuplicateIdCheck(const Context& context, const Servo& servo)
        : m_context(context)
        , m_servo(servo)
    {
        std::vector<const catalog::Register*> registers;
        for (const catalog::Register& reg : servo.profile->registers) {
            if (distinguishesServos(reg, servo.protocol))
                registers.push_back(&reg);
        }
        m_spans = planSpans(*servo.profile, registers);
    }

    base::Result<DuplicateIdResult> run()
    {
        m_context.bus.takeUnexpectedFrames();
        for (int round = 0; round < maxRounds; ++round) {
            if (m_context.stop.isRequested())
                return base::fail(ErrorCode::Stopped, QStringLiteral("identify"), {}, m_servo.id);
            const int before = replyCount();
            if (const auto done = oneRound(round == 0); !done)
                return tl::unexpected(done.error());
            if (const auto verdict = evaluate())
                return *verdict;
            m_silentRounds = replyCount() == before ? m_silentRounds + 1 : 0;
            if (m_silentRounds >= maxSilentRounds)
                return noReplyError();
        }
        return inconclusive();
    }

private:
    int replyCount() const { return m_clean + m_broken + m_secondReplies; }

    base::Result<DuplicateIdResult> noReplyError() const
    {
        return base::fail(ErrorCode::NoReply, QStringLiteral("identify"), {}, m_servo.id);
    }

    /// The result for signs that were not seen twice. Lost replies are no sign of a second servo.
    base::Result<DuplicateIdResult> inconclusive() const
    {
        if (m_broken > 0)
            return finding(DuplicateIdSign::BrokenReplies);
        if (m_secondReplies > 0)
            return finding(DuplicateIdSign::SecondReply);
        return m_differences > 0
                   ? base::Result<DuplicateIdResult>(finding(DuplicateIdSign::DifferentValues))
                   : noReplyError();
    }

    DuplicateIdResult finding(DuplicateIdSign sign) const
    {
        DuplicateIdResult found{sign, m_clean + m_broken, m_broken, std::nullopt};
        if (m_last)
            found.lock = m_last->raw(Role::Lock);
        return found;
    }

    std::optional<DuplicateIdResult> evaluate() const
    {
        if (m_secondReplies >= minSigns)
            return finding(DuplicateIdSign::SecondReply);
        if (m_differences >= minSigns)
            return finding(DuplicateIdSign::DifferentValues);
        const int needed = minGoodRounds * (1 + m_secondReplies + m_differences);
        if (m_goodRounds >= needed && m_clean >= 2 * m_broken)
            return finding(DuplicateIdSign::None);
        if (m_broken >= maxBroken && m_broken > m_clean)
            return finding(DuplicateIdSign::BrokenReplies);
        return std::nullopt;
    }

    base::Result<void> oneRound(bool first)
    {
        Servo current = m_servo;
        current.image.clear();
        const int brokenBefore = m_broken;
        const auto missing = readMissing(current);
        if (!missing)
            return tl::unexpected(missing.error());
        const bool complete = *missing == 0;
        // A second reply may be as late as this link ever was. Waiting once is enough only if
        // nothing unusual has been seen.
        const bool isInconclusive = m_broken > brokenBefore || m_secondReplies + m_differences > 0;
        if (first || isInconclusive) {
            if (const auto replyCount = m_context.bus.listen(m_context.bus.maxReplyLateness());
                !replyCount)
                return replyCount;
        }
        countSecondReplies();
        if (complete)
            compare(std::move(current));
        return {};
    }

    /// Returns how many spans could not be read. On a poor line a map in many pieces is rarely read
    /// in one pass, so missing spans are read again while anything new comes; every broken reply
    /// counts.
    base::Result<std::size_t> readMissing(Servo& current)
    {
        std::vector<bus::PollSpan> missing = m_spans;
        for (int pass = 0; pass < maxPasses; ++pass) {
            std::vector<bus::PollSpan> unanswered;
            for (const bus::PollSpan& span : missing) {
                const auto answered = readOnce(current, span);
                if (!answered)
                    return tl::unexpected(answered.error());
                if (!*answered)
                    unanswered.push_back(span);
            }
            const bool stuck = unanswered.size() == missing.size();
            missing = std::move(unanswered);
            if (missing.empty() || stuck)
                break;
        }
        return missing.size();
    }

    /// False: nothing usable came.
    base::Result<bool> readOnce(Servo& current, const bus::PollSpan& span)
    {
        bus::Transaction transaction;
        transaction.request =
            protocol::Request::read(current.id, span.address, span.count).in(current.protocol);
        transaction.priority = m_context.priority;
        transaction.retries = 0; // a repeated read would hide the signs
        transaction.hold = m_context.hold;
        transaction.epoch = m_context.epoch;
        transaction.stop = &m_context.stop;
        const auto outcome = m_context.bus.transact(transaction);
        if (!outcome)
            return failedRead(outcome.error());
        ++m_clean;
        current.image.store(span.address, outcome->data(), outcome->sentAt + outcome->roundTrip);
        return true;
    }

    base::Result<bool> failedRead(const base::Error& error)
    {
        switch (error.code) {
        case ErrorCode::Garbled:
        case ErrorCode::UnexpectedReply:
            ++m_broken;
            return false;
        case ErrorCode::Refused: // a Modbus station without this register
            ++m_clean;
            return true;
        case ErrorCode::NoReply: {
            // Its reply may still come, damaged or not, and must not be taken for a second one.
            bus::DamagedReplyWatch watch(m_context.bus);
            const auto replyCount = m_context.bus.listen(m_context.bus.maxReplyLateness());
            m_context.bus.takeUnexpectedFrames();
            if (watch.hasReplyCome())
                ++m_broken;
            return replyCount ? base::Result<bool>(false) : tl::unexpected(replyCount.error());
        }
        default:
            return tl::unexpected(error);
        }
    }

    void countSecondReplies()
    {
        const auto strays = m_context.bus.takeUnexpectedFrames();
        const bool second =
            std::any_of(strays.begin(), strays.end(), [this](const bus::UnexpectedFrame& stray) {
                return stray.id == m_servo.id;
            });
        m_secondReplies += second ? 1 : 0;
    }

    void compare(Servo current)
    {
        const base::Duration now = m_context.bus.clock().now();
        const bool differs = m_last && (settingsDiffer(*m_last, current) ||
                                        !canBeOneServo(*m_last, current, now - m_at));
        m_differences += differs ? 1 : 0;
        m_goodRounds += differs ? 0 : 1;
        m_last = std::move(current);
        m_at = now;
    }

    static bool settingsDiffer(const Servo& before, const Servo& after)
    {
        const auto& registers = before.profile->registers;
        return std::any_of(registers.begin(), registers.end(), [&](const catalog::Register& reg) {
            const auto was = before.image.bytes(reg.offset, reg.size);
            const auto is = after.image.bytes(reg.offset, reg.size);
            return isConstant(reg) && was && is && *was != *is;
        });
    }

    const Context& m_context;
    const Servo& m_servo;
    std::vector<bus::PollSpan> m_spans;
    std::optional<Servo> m_last; ///< the latest whole round
    base::Duration m_at{};
    int m_goodRounds = 0;
    int m_clean = 0;
    int m_broken = 0;
    int m_silentRounds = 0;  ///< on end, until now
    int m_secondReplies = 0; ///< rounds with one
    int m_differences = 0;   ///< rounds that differ from the one before
};

double difference(const Servo& a, const Servo& b, Role role)
{
    const auto before = a.physical(role);
    const auto after = b.physical(role);
    return before && after ? std::abs(*after - *before) : 0;
}

/// A turn in the unit of the present position: degrees, or steps where the range is not known.
double stepsOrDegreesPerTurn(const Servo& servo)
{
    const catalog::Register* position = servo.profile->byRole(Role::PresentPosition);
    const bool degrees =
        position != nullptr && servo.meaning(*position).unit == QLatin1String("deg");
    return degrees ? turnDegrees : servo.profile->stepsPerTurn;
}

bool isResting(const Servo& servo)
{
    return servo.raw(Role::PresentSpeed).value_or(1) == 0 &&
           servo.raw(Role::Moving).value_or(1) == 0;
}
} // namespace

bool canBeOneServo(const Servo& before, const Servo& after, base::Duration apart)
{
    if (difference(before, after, Role::PresentTemperature) > maxTemperatureJump + jumpSlack ||
        difference(before, after, Role::PresentVoltage) > maxVoltageJump + jumpSlack)
        return false;
    const double turn = stepsOrDegreesPerTurn(after);
    // SCS and LX servos cannot measure a part of the turn, and report either end of the rest there.
    const double measured = after.profile->angleRangeDeg.value_or(turnDegrees);
    const double blindFraction = std::max(0.0, turnDegrees - measured) / turnDegrees;
    const double within = std::fmod(difference(before, after, Role::PresentPosition), turn) / turn;
    // The seam of a turn is no jump.
    const double moved = std::min(within, std::max(0.0, 1 - within - blindFraction)) * stepsPerTurn;
    double possible = restJitterSteps;
    if (!isResting(before) || !isResting(after)) {
        possible += fastestStepsPerSecond * double(apart.count()) / 1e6;
        possible +=
            blindFraction * stepsPerTurn; // a turning motor may pass it between two readings
    }
    return moved <= possible;
}

base::Result<DuplicateIdResult> checkDuplicateId(const Context& context, const Servo& servo)
{
    return DuplicateIdCheck(context, servo).run();
}
} // namespace device
