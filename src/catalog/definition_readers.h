// SPDX-License-Identifier: GPL-3.0-or-later
// From one JSON row to one definition. Each reader returns nullopt and says what is wrong in
// `problem` when the row cannot be used. Pure functions; any thread.
#pragma once

#include "catalog/definition.h"

#include <QJsonValue>

namespace catalog {
std::optional<RegisterRow> readRegister(const QJsonValue& row, base::Protocol protocol,
                                        QString& errorText);
std::optional<SeriesDef> readSeries(const QJsonValue& row, QString& errorText);

/// `line` is not in the row: it follows from the series and is filled in by the loader.
std::optional<ModelEntry> readModel(const QJsonValue& row, QString& errorText);

std::optional<FirmwareDef> readFirmware(const QJsonValue& row, QString& errorText);
} // namespace catalog
