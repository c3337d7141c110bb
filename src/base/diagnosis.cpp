// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/diagnosis.h"

#include "base/enum_names.h"

namespace base {
namespace {
constexpr EnumName<Cause> names[] = {
    {Cause::Found, "found"},
    {Cause::PortMissing, "port-missing"},
    {Cause::PortPermission, "port-permission"},
    {Cause::PortBusy, "port-busy"},
    {Cause::PortFailed, "port-failed"},
    {Cause::NoServoOrNoPower, "no-servo-or-no-power"},
    {Cause::EchoOnly, "echo-only"},
    {Cause::WrongBaudRate, "wrong-baud-rate"},
    {Cause::OtherProtocol, "other-protocol"},
    {Cause::TwoServosOneId, "two-servos-one-id"},
    {Cause::LateAdapter, "late-adapter"},
    {Cause::ResponseLevel0, "response-level-0"},
    {Cause::Noise, "noise"},
    {Cause::BoardNotAdapter, "board-not-adapter"},
    {Cause::Bootloader, "bootloader"},
};
} // namespace

QString causeName(Cause cause)
{
    return nameOf(names, cause);
}
} // namespace base
