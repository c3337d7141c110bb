// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/reader.h"

#include "device/talk.h"

#include <QStringList>

#include <algorithm>

namespace device {
using base::ErrorCode;
using base::Protocol;
using catalog::Role;

namespace {
// Firmware, byte order, model, ID, rate, delay, level: the same place in every Feetech table.
constexpr int feetechHead = 9;
constexpr int modbusHead = 8; ///< registers 0–3

/// The stored move of an LX servo: some models never answer the command that reads it.
bool maySilent(const catalog::Register& reg)
{
    return reg.role == Role::StoredGoal || reg.role == Role::StoredTime;
}
} // namespace

std::vector<bus::PollSpan> planSpans(const catalog::Profile& profile,
                                     const std::vector<const catalog::Register*>& registers)
{
    std::vector<const catalog::Register*> sorted = registers;
    std::sort(sorted.begin(), sorted.end(),
              [](const auto* a, const auto* b) { return a->offset < b->offset; });
    std::vector<bus::PollSpan> spans;
    for (const catalog::Register* reg : sorted) {
        const bus::PollSpan own = reg->block ? bus::PollSpan{reg->block->offset, reg->block->size}
                                             : bus::PollSpan{reg->offset, reg->size};
        const int end = own.address + own.count;
        if (!spans.empty() && spans.back() == own)
            continue;
        if (!spans.empty() && profile.readGap >= 0) {
            bus::PollSpan& last = spans.back();
            const int lastEnd = last.address + last.count;
            if (own.address <= lastEnd + profile.readGap && end - last.address <= profile.maxRead) {
                last.count = std::max(lastEnd, end) - last.address;
                continue;
            }
        }
        spans.push_back(own);
    }
    return spans;
}

namespace {
base::Result<catalog::Identity> askFeetech(const Context& context, Servo& servo, int retries)
{
    if (const auto done = readBlock(context, servo, 0, feetechHead, retries); !done)
        return tl::unexpected(done.error());
    const base::Bytes head = *servo.image.bytes(0, feetechHead);
    catalog::Identity identity;
    identity.firmwareMajor = head[0];
    identity.firmwareMinor = head[1];
    identity.byteOrderFlag = head[2] <= 1 ? head[2] : -1;
    identity.modelMajor = head[3];
    identity.modelMinor = head[4];
    return identity;
}

base::Result<catalog::Identity> askModbus(const Context& context, Servo& servo, int retries)
{
    if (const auto done = readBlock(context, servo, 0, modbusHead, retries); !done)
        return tl::unexpected(done.error());
    const base::Bytes head = *servo.image.bytes(0, modbusHead);
    catalog::Identity identity;
    identity.protocol = Protocol::Modbus;
    identity.firmwareMajor = head[0] << 8 | head[1];
    identity.firmwareMinor = head[2] << 8 | head[3];
    return identity;
}

/// An LX servo tells its ID and nothing else.
base::Result<catalog::Identity> askLx(const Context& context, Servo& servo, int retries)
{
    catalog::Identity identity;
    identity.protocol = Protocol::Lx;
    const auto profile = context.catalog.resolve(identity);
    const catalog::Register* id = profile->byRole(Role::Id);
    if (id == nullptr)
        return base::fail(ErrorCode::UnknownModel, {}, {}, servo.id);
    if (const auto done = readBlock(context, servo, id->offset, id->size, retries); !done)
        return tl::unexpected(done.error());
    return identity;
}

base::Result<catalog::Identity> ask(const Context& context, Servo& servo, int retries)
{
    switch (servo.protocol) {
    case Protocol::Modbus:
        return askModbus(context, servo, retries);
    case Protocol::Lx:
        return askLx(context, servo, retries);
    case Protocol::Feetech:
        break;
    }
    return askFeetech(context, servo, retries);
}
} // namespace

namespace {
base::Result<Servo> identifyTrying(const Context& context, int id, Protocol protocol, int retries)
{
    Servo servo;
    servo.protocol = protocol;
    servo.id = id;
    servo.baud = context.bus.baud();
    servo.port = context.bus.portName();
    auto identity = ask(context, servo, retries);
    if (!identity) {
        identity.error().operation = QStringLiteral("identify");
        return tl::unexpected(identity.error());
    }
    servo.profile = context.catalog.resolve(*identity);
    return servo;
}

constexpr int usualRetries = -1;

/// Says something about the servo; the others end the whole question.
bool concernsServo(ErrorCode code)
{
    switch (code) {
    case ErrorCode::LinkLost:
    case ErrorCode::Stopped:
    case ErrorCode::Preempted:
    case ErrorCode::Held:
        return false;
    default:
        return true;
    }
}
} // namespace

base::Result<Servo> identify(const Context& context, int id, Protocol protocol)
{
    return identifyTrying(context, id, protocol, usualRetries);
}

namespace {
/// Once, and again only if something came that was no answer: where one language answers, the
/// silence of the others must not cost every command their retries.
base::Result<Servo> askBriefly(const Context& context, int id, Protocol protocol)
{
    auto servo = identifyTrying(context, id, protocol, 0);
    const bool heard = !servo && (servo.error().code == ErrorCode::Garbled ||
                                  servo.error().code == ErrorCode::WrongAnswer ||
                                  servo.error().code == ErrorCode::LineBusy);
    return heard ? identify(context, id, protocol) : servo;
}

/// `asking` puts the question in one language.
template <typename Asking>
base::Result<Servo> identifyBy(int id, const std::vector<Protocol>& protocols, Asking&& asking)
{
    std::optional<Servo> found;
    QStringList languages;
    base::Error failure{ErrorCode::NoAnswer, QStringLiteral("identify"), {}, id};
    for (const Protocol protocol : protocols) {
        Servo nobody;
        nobody.protocol = protocol;
        if (!canSay(nobody, protocol::Request::ping(id)))
            continue; // an ID that this language does not have
        auto servo = asking(protocol);
        if (servo) {
            languages << base::protocolName(protocol);
            found = std::move(*servo);
        } else if (!concernsServo(servo.error().code)) {
            return servo;
        } else if ((failure.code == ErrorCode::NoAnswer && failure.detail.isEmpty()) ||
                   servo.error().code == ErrorCode::LineBusy) {
            failure = servo.error();
        }
    }
    if (languages.size() > 1) {
        return base::fail(ErrorCode::SeveralProtocols, QStringLiteral("identify"),
                          languages.join(QStringLiteral(", ")), id);
    }
    if (found)
        return std::move(*found);
    return tl::unexpected(failure);
}
} // namespace

base::Result<Servo> identifyAmong(const Context& context, int id,
                                  const std::vector<Protocol>& protocols)
{
    if (protocols.size() > 1) {
        auto found = identifyBy(
            id, protocols, [&](Protocol protocol) { return askBriefly(context, id, protocol); });
        if (found || !answerLost(found.error()))
            return found;
    }
    return identifyBy(id, protocols,
                      [&](Protocol protocol) { return identify(context, id, protocol); });
}

namespace {
/// False: it stayed silent, as it may, and what it holds is not known.
base::Result<bool> readSpan(const Context& context, Servo& servo, const bus::PollSpan& span)
{
    const catalog::Register* reg = servo.profile->at(span.address);
    const bool silentAllowed = reg != nullptr && maySilent(*reg);
    const auto done = readBlock(context, servo, span.address, span.count, silentAllowed ? 0 : -1);
    if (done)
        return true;
    if (!silentAllowed || done.error().code != ErrorCode::NoAnswer)
        return tl::unexpected(done.error());
    servo.image.forget(span.address, span.count);
    return false;
}

base::Result<void> readTable(const Context& context, Servo& servo,
                             const std::vector<const catalog::Register*>& registers)
{
    for (const bus::PollSpan& span : planSpans(*servo.profile, registers)) {
        if (const auto done = readSpan(context, servo, span); !done)
            return tl::unexpected(done.error());
    }
    return {};
}
} // namespace

base::Result<void> read(const Context& context, Servo& servo,
                        const std::vector<const catalog::Register*>& registers)
{
    for (const bus::PollSpan& span : planSpans(*servo.profile, registers)) {
        const auto answered = readSpan(context, servo, span);
        if (!answered)
            return tl::unexpected(answered.error());
        if (!*answered) {
            return tl::unexpected(base::Error{ErrorCode::NotSupported, QStringLiteral("read"),
                                              QStringLiteral("not-readable"), servo.id,
                                              servo.profile->at(span.address)->key});
        }
    }
    return {};
}

base::Result<void> readKeys(const Context& context, Servo& servo, const QStringList& keys)
{
    std::vector<const catalog::Register*> registers;
    for (const QString& key : keys) {
        const catalog::Register* reg = servo.profile->find(key);
        if (reg == nullptr) {
            return tl::unexpected(base::Error{ErrorCode::UnknownRegister, QStringLiteral("read"),
                                              key, servo.id, key});
        }
        registers.push_back(reg);
    }
    return read(context, servo, registers);
}

base::Result<void> readRoles(const Context& context, Servo& servo, const std::vector<Role>& roles)
{
    std::vector<const catalog::Register*> registers;
    for (const Role role : roles) {
        if (const catalog::Register* reg = servo.profile->byRole(role))
            registers.push_back(reg);
    }
    return read(context, servo, registers);
}

base::Result<void> readAll(const Context& context, Servo& servo)
{
    std::vector<const catalog::Register*> registers;
    for (const catalog::Register& reg : servo.profile->registers)
        registers.push_back(&reg);
    return readTable(context, servo, registers);
}

namespace {
std::vector<const catalog::Register*> settingsOf(const catalog::Profile& profile)
{
    using catalog::Area;
    std::vector<const catalog::Register*> registers;
    for (const catalog::Register& reg : profile.registers) {
        const bool setting = reg.area == Area::Eprom || reg.area == Area::Sram ||
                             (reg.area == Area::Factory && reg.writable());
        if (setting && !maySilent(reg))
            registers.push_back(&reg);
    }
    return registers;
}
} // namespace

base::Result<void> readSettings(const Context& context, Servo& servo)
{
    return readTable(context, servo, settingsOf(*servo.profile));
}

bool settingsReadSince(const Servo& servo, base::Duration since)
{
    const auto settings = settingsOf(*servo.profile);
    return std::all_of(settings.begin(), settings.end(), [&](const catalog::Register* reg) {
        const auto at = servo.image.readAt(reg->offset);
        return at && *at >= since;
    });
}
} // namespace device
