// SPDX-License-Identifier: GPL-3.0-or-later
// Turns an error of the file system into an Error: DiskFull when there is no room (also a
// used-up quota or size limit), otherwise the code given. detail is "PATH: system message". Pure;
// any thread.
#pragma once

#include "base/error.h"

#include <QFileDevice>

#include <optional>

namespace files {
base::Error fileError(base::ErrorCode otherwise, const QString& operation, const QString& path,
                      int systemError);

/// For a QFile that has just failed to open, write or commit.
base::Error fileError(const QString& operation, const QFileDevice& file);

/// Writes to a file that was opened Unbuffered. Qt answers a short count without a reason when the
/// disk becomes full half-way; the attempt to write the rest brings the reason.
bool writeAll(QFileDevice& file, const QByteArray& bytes);

/// What must not be written to under this name: a pipe would be waited for until something reads
/// it, and a disk is no file. Devices such as a terminal or /dev/null may be, and this program's
/// own output. Nothing: it may be written.
std::optional<base::Error> writeRefusal(const QString& operation, const QString& path);

/// For an empty path, which Qt would complain about on stderr.
base::Error noFileNameError(const QString& operation);
} // namespace files
