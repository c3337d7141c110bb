// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/firmware_text.h"

#include "text/bus_text.h"
#include "text/translate.h"

namespace text {
namespace {
using base::FirmwareCheck;
using base::FirmwareCheckResult;
using base::FirmwareOutcome;

QString otherServosText(const FirmwareCheckResult& result)
{
    if (result.isPassed)
        return translate("text", "No other servo replies on this port.");
    return translate("text", "Other servos reply on this port: ID %1. They receive the firmware "
                             "data too, and a second servo in its bootloader would store it.")
        .arg(idRangesText(result.ids));
}

QString fileNameText(const FirmwareCheckResult& result)
{
    if (result.isPassed)
        return translate("text", "The file name fits this model.");
    if (result.text.isEmpty())
        return translate("text", "No firmware file is known for this model, so the file name "
                                 "cannot be checked.");
    return translate("text", "The file name does not fit this model; the vendor's file is named "
                             "like %1.bin. Firmware for another model can make a servo unusable.")
        .arg(result.text);
}

QString fileSizeText(const FirmwareCheckResult& result)
{
    const QString size = translate("text", "The file has %1 bytes.").arg(result.number);
    return result.isPassed ? size
                           : size + QLatin1Char(' ') +
                                 translate("text", "Known servos have room for 29,696 bytes only.");
}

QString supplyText(const FirmwareCheckResult& result)
{
    if (result.high == 0)
        return translate("text", "The servo's supply voltage could not be measured.");
    const QString low = QString::number(result.low, 'f', 1);
    const QString high = QString::number(result.high, 'f', 1);
    const QString measured =
        low == high ? translate("text", "The servo measures %1 V with torque off and on.").arg(low)
                    : translate("text", "The servo measures %1 to %2 V with torque off and on.")
                          .arg(low, high);
    return result.isPassed
               ? measured
               : measured + QLatin1Char(' ') +
                     translate("text", "The supply must be steady and within the servo's limits.");
}

QString savedTableText(const FirmwareCheckResult& result)
{
    if (result.isPassed)
        return translate("text", "The memory table is saved.");
    return translate("text", "The memory table could not be saved (%1), so changed settings could "
                             "not be restored.")
        .arg(result.text);
}

QString batteryText(const FirmwareCheckResult& result)
{
    if (result.isPassed)
        return translate("text", "This computer has enough power.");
    return translate("text", "This computer's battery has %1 % left. Connect the charger.")
        .arg(result.number);
}
} // namespace

QString firmwareCheckLabel(FirmwareCheck check)
{
    switch (check) {
    case FirmwareCheck::OtherServos:
        return translate("text", "Other servos");
    case FirmwareCheck::FileName:
        return translate("text", "File name");
    case FirmwareCheck::FileSize:
        return translate("text", "File size");
    case FirmwareCheck::Supply:
        return translate("text", "Power supply");
    case FirmwareCheck::SavedTable:
        return translate("text", "Memory table");
    case FirmwareCheck::Battery:
        return translate("text", "Battery");
    }
    return {};
}

QString firmwareCheckText(const FirmwareCheckResult& result)
{
    switch (result.check) {
    case FirmwareCheck::OtherServos:
        return otherServosText(result);
    case FirmwareCheck::FileName:
        return fileNameText(result);
    case FirmwareCheck::FileSize:
        return fileSizeText(result);
    case FirmwareCheck::Supply:
        return supplyText(result);
    case FirmwareCheck::SavedTable:
        return savedTableText(result);
    case FirmwareCheck::Battery:
        return batteryText(result);
    }
    return {};
}

QString firmwareOutcomeText(FirmwareOutcome outcome)
{
    switch (outcome) {
    case FirmwareOutcome::Updated:
        return translate("text", "The servo runs the new firmware.");
    case FirmwareOutcome::Unchanged:
        return translate("text", "The servo still has its old firmware.");
    case FirmwareOutcome::Incomplete:
        return translate("text", "The servo has no complete firmware and is in its bootloader.");
    case FirmwareOutcome::Unknown:
        return translate("text", "It is not known whether the servo runs the new firmware.");
    }
    return {};
}

QString firmwareOutcomeRemedy(FirmwareOutcome outcome)
{
    switch (outcome) {
    case FirmwareOutcome::Updated:
        return {};
    case FirmwareOutcome::Unchanged:
        return translate("text", "Correct the cause, then update again.");
    case FirmwareOutcome::Incomplete:
        return translate("text", "Connect only this servo and rescue it with the same file.");
    case FirmwareOutcome::Unknown:
        return translate("text", "Turn the servo's supply off and on, search for it, and compare "
                                 "the versions. If it does not reply, rescue it with the same "
                                 "file.");
    }
    return {};
}

QString firmwareChangesText(int count)
{
    return count == 0
               ? translate("text", "All settings are as before.")
               : translate("text", "%n setting(s) changed with the firmware:", nullptr, count);
}

QString firmwareTableUnreadText()
{
    return translate("text", "The memory table could not be read afterwards, so changed settings "
                             "are not listed.");
}

QString firmwareUntriedText()
{
    return translate("text", "We have not tried firmware updates on real servos yet; the steps are "
                             "those published by others.");
}
} // namespace text
