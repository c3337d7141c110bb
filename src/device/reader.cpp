// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/reader.h"

#include "device/transactions.h"

#include <QStringList>

#include <algorithm>

namespace device {
using base::ErrorCode;
using base::Protocol;
using catalog::Role;

namespace {
// Firmware, byte order, model, ID, rate, delay, level: at the same address in every Feetech table.
constexpr int feetechHead = 9;
constexpr int modbusHead = 8; ///< registers 0–3

/// The stored move of an LX servo: some models never answer the command that reads it.
bool mayNotReply(const catalog::Register& reg)
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
        const bus::PollSpan span = reg->block ? bus::PollSpan{reg->block->offset, reg->block->size}
                                              : bus::PollSpan{reg->offset, reg->size};
        const int end = span.address + span.count;
        if (!spans.empty() && spans.back() == span)
            continue;
        if (!spans.empty() && profile.readGap >= 0) {
            bus::PollSpan& last = spans.back();
            const int lastEnd = last.address + last.count;
            if (span.address <= lastEnd + profile.readGap &&
                end - last.address <= profile.maxRead) {
                last.count = std::max(lastEnd, end) - last.address;
                continue;
            }
        }
        spans.push_back(span);
    }
    return spans;
}

namespace {
base::Result<catalog::Identity> queryFeetech(const Context& context, Servo& servo, int retries)
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

base::Result<catalog::Identity> queryModbus(const Context& context, Servo& servo, int retries)
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

/// An LX servo reports its ID and nothing else.
base::Result<catalog::Identity> queryLx(const Context& context, Servo& servo, int retries)
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

base::Result<catalog::Identity> query(const Context& context, Servo& servo, int retries)
{
    switch (servo.protocol) {
    case Protocol::Modbus:
        return queryModbus(context, servo, retries);
    case Protocol::Lx:
        return queryLx(context, servo, retries);
    case Protocol::Feetech:
        break;
    }
    return queryFeetech(context, servo, retries);
}
} // namespace

namespace {
base::Result<Servo> identifyWithRetries(const Context& context, int id, Protocol protocol,
                                        int retries)
{
    Servo servo;
    servo.protocol = protocol;
    servo.id = id;
    servo.baud = context.bus.baud();
    servo.port = context.bus.portName();
    auto identity = query(context, servo, retries);
    if (!identity) {
        identity.error().operation = QStringLiteral("identify");
        return tl::unexpected(identity.error());
    }
    servo.profile = context.catalog.resolve(*identity);
    return servo;
}

constexpr int defaultRetries = -1;
} // namespace

base::Result<Servo> identify(const Context& context, int id, Protocol protocol)
{
    return identifyWithRetries(context, id, protocol, defaultRetries);
}

namespace {
/// Asks once, and again only if bytes came that were no reply: where one protocol answers, the
/// silence of the others must not cost every command their retries.
base::Result<Servo> identifyQuickly(const Context& context, int id, Protocol protocol)
{
    auto servo = identifyWithRetries(context, id, protocol, 0);
    const bool garbled = !servo && (servo.error().code == ErrorCode::Garbled ||
                                    servo.error().code == ErrorCode::UnexpectedReply ||
                                    servo.error().code == ErrorCode::LineBusy);
    return garbled ? identify(context, id, protocol) : servo;
}

/// `asking` sends the request in one protocol.
template <typename Identify>
base::Result<Servo> identifyBy(int id, const std::vector<Protocol>& protocols,
                               Identify&& identifyWith)
{
    std::optional<Servo> found;
    QStringList protocolNames;
    base::Error failure{ErrorCode::NoReply, QStringLiteral("identify"), {}, id};
    for (const Protocol protocol : protocols) {
        Servo probe;
        probe.protocol = protocol;
        if (!canEncode(probe, protocol::Request::ping(id)))
            continue; // an ID that this protocol does not have
        auto servo = identifyWith(protocol);
        if (servo) {
            protocolNames << base::protocolName(protocol);
            found = std::move(*servo);
        } else if (base::endsJob(servo.error().code)) {
            return servo;
        } else if ((failure.code == ErrorCode::NoReply && failure.detail.isEmpty()) ||
                   servo.error().code == ErrorCode::LineBusy) {
            failure = servo.error();
        }
    }
    if (protocolNames.size() > 1) {
        return base::fail(ErrorCode::AmbiguousProtocol, QStringLiteral("identify"),
                          protocolNames.join(QStringLiteral(", ")), id);
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
        auto found = identifyBy(id, protocols, [&](Protocol protocol) {
            return identifyQuickly(context, id, protocol);
        });
        if (found || !isReplyLost(found.error()))
            return found;
    }
    return identifyBy(id, protocols,
                      [&](Protocol protocol) { return identify(context, id, protocol); });
}

namespace {
/// False: the servo did not answer, as some models do, and its stored move is not known.
base::Result<bool> readSpan(const Context& context, Servo& servo, const bus::PollSpan& span)
{
    const catalog::Register* reg = servo.profile->at(span.address);
    const bool mayBeSilent = reg != nullptr && mayNotReply(*reg);
    const auto done = readBlock(context, servo, span.address, span.count, mayBeSilent ? 0 : -1);
    if (done)
        return true;
    if (!mayBeSilent || done.error().code != ErrorCode::NoReply)
        return tl::unexpected(done.error());
    servo.image.invalidate(span.address, span.count);
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
        if (setting && !mayNotReply(reg))
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
