// SPDX-License-Identifier: GPL-3.0-or-later
// What is checked before a firmware update, and how it ended. Data only; made by jobs/firmware,
// worded by the text layer. Any thread.
#pragma once

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace base {
enum class FirmwareCheck : std::uint8_t {
    OtherServos, ///< alone on the bus
    FileName,    ///< names the servo's line and bus
    FileSize,    ///< fits the parts that are known
    Supply,      ///< steady, and within the servo's limits
    SavedTable,  ///< the memory table is in a file
    Battery,     ///< this computer will not run out of power
};
QString firmwareCheckName(FirmwareCheck check); ///< "other-servos", "file-name" …
std::optional<FirmwareCheck> firmwareCheckOf(const QString& name);
QStringList firmwareCheckNames();

struct FirmwareCheckResult {
    FirmwareCheck check = FirmwareCheck::OtherServos;
    bool isPassed = true;
    std::vector<int> ids{}; ///< OtherServos: those
    double low = 0;         ///< Supply: volts
    double high = 0;
    int number = 0; ///< FileSize: bytes; Battery: percent
    QString text{}; ///< FileName: the vendor's name for such a file; SavedTable: the
                    ///< system's word why it is not
};

enum class FirmwareOutcome : std::uint8_t {
    Updated,    ///< the servo has answered, and its version was read
    Unchanged,  ///< no block was accepted: the servo has its old firmware
    Incomplete, ///< it has none, and stays in its bootloader
    Unknown,    ///< the servo does not reply any more, or it is not clear which one it is
};
QString firmwareOutcomeName(FirmwareOutcome outcome);
} // namespace base
