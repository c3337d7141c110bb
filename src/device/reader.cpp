// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/reader.h"

#include "device/talk.h"

#include <QStringList>

#include <algorithm>

namespace device {
namespace {
// Firmware, byte order, model, ID, rate, delay, level: the same place in every Feetech table.
constexpr int identityBytes = 9;
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

base::Result<Servo> identify(const Context& context, int id, base::Protocol protocol)
{
    Servo servo;
    servo.protocol = protocol;
    servo.id = id;
    servo.baud = context.bus.baud();
    servo.port = context.bus.portName();
    auto done = readBlock(context, servo, 0, identityBytes);
    if (!done) {
        done.error().operation = QStringLiteral("identify");
        return tl::unexpected(done.error());
    }
    const base::Bytes head = *servo.image.bytes(0, identityBytes);
    catalog::Identity identity;
    identity.firmwareMajor = head[0];
    identity.firmwareMinor = head[1];
    identity.byteOrderFlag = head[2] <= 1 ? head[2] : -1;
    identity.modelMajor = head[3];
    identity.modelMinor = head[4];
    servo.profile = context.catalog.resolve(identity);
    return servo;
}

base::Result<void> read(const Context& context, Servo& servo,
                        const std::vector<const catalog::Register*>& registers)
{
    for (const bus::PollSpan& span : planSpans(*servo.profile, registers)) {
        const auto done = readBlock(context, servo, span.address, span.count);
        if (!done)
            return done;
    }
    return {};
}

base::Result<void> readKeys(const Context& context, Servo& servo, const QStringList& keys)
{
    std::vector<const catalog::Register*> registers;
    for (const QString& key : keys) {
        const catalog::Register* reg = servo.profile->find(key);
        if (reg == nullptr) {
            return tl::unexpected(base::Error{base::ErrorCode::UnknownRegister,
                                              QStringLiteral("read"), key, servo.id, key});
        }
        registers.push_back(reg);
    }
    return read(context, servo, registers);
}

base::Result<void> readRoles(const Context& context, Servo& servo,
                             const std::vector<catalog::Role>& roles)
{
    std::vector<const catalog::Register*> registers;
    for (const catalog::Role role : roles) {
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
    return read(context, servo, registers);
}

base::Result<void> readSettings(const Context& context, Servo& servo)
{
    std::vector<const catalog::Register*> registers;
    for (const catalog::Register& reg : servo.profile->registers) {
        if (reg.area == catalog::Area::Eprom || reg.area == catalog::Area::Sram)
            registers.push_back(&reg);
    }
    return read(context, servo, registers);
}
} // namespace device
