// SPDX-License-Identifier: GPL-3.0-or-later
// The catalog as the files state it, before series and firmware are known: rows with conditions.
// Internal to the layer; immutable once loaded; any thread.
#pragma once

#include "catalog/catalog.h"

#include <compare>
#include <map>
#include <utility>

namespace catalog {
/// A firmware version; 9.1 and 9.10 differ, so it is never a fraction.
struct Version {
    int major = 0;
    int minor = 0;
    auto operator<=>(const Version&) const = default;
};

/// Fits a servo when every part that is set fits.
struct Condition {
    QStringList series; ///< empty: any
    std::optional<Version> from;
    std::optional<Version> to; ///< inclusive
    bool fits(const QString& ofSeries, Version firmware) const;
};

/// True for an empty list: no condition, everywhere.
bool anyFits(const std::vector<Condition>& conditions, const QString& series, Version firmware);

/// Steps, or steps per second, that become degrees or rpm where the model's range is known.
enum class Angular : std::uint8_t { No, Position, Speed };

struct RegisterDef {
    Register reg;
    std::vector<std::vector<Condition>> valueOnly; ///< parallel to reg.values
    Angular angular = Angular::No;
};

/// One row of a map: the register, where it exists, and how it differs under a condition.
struct RegisterRow {
    RegisterDef base;
    std::vector<Condition> only;
    std::vector<std::pair<Condition, RegisterDef>> set; ///< the first that fits replaces the base
    const RegisterDef* pick(const QString& series, Version firmware) const; ///< null: absent
};

struct MapDef {
    QString key;
    base::Protocol protocol = base::Protocol::Feetech;
    std::vector<RegisterRow> rows;
};

/// A family: which firmware it has, and what its servos can do.
struct SeriesDef {
    QString key;
    QString map;                                       ///< empty: no register map is known
    base::Protocol protocol = base::Protocol::Feetech; ///< its map's, if it has one
    std::optional<Version> from; ///< both or neither: with Feetech the firmware names the family,
    std::optional<Version> to;   ///< elsewhere the language may do so alone; inclusive
    base::ByteOrder byteOrder = base::ByteOrder::Little;
    Line line = Line::Unknown;
    int stepsPerTurn = 4096;
    std::optional<double> angleRangeDeg;
    std::optional<int> defaultBaud;
    bool syncRead = false;
    bool damping = false;
    bool multiTurn = false;
    Centering centering = Centering::None;
    std::optional<Version> centeringFrom; ///< first firmware that has it
    std::vector<Mode> modes;
};

/// A firmware known for some models, or for all servos of a protocol without model numbers.
struct FirmwareDef {
    base::Protocol protocol = base::Protocol::Feetech;
    std::optional<Version> fromModel; ///< both or neither
    std::optional<Version> toModel;   ///< inclusive
    base::ByteOrder byteOrder = base::ByteOrder::Little;
    Version version;
    QDate date;
    QString source;
};

/// A model's name as people type it: neither case, blanks nor '-' matter ("lx16a" is "LX-16A").
QString normalizedModelName(const QString& name);

struct Catalog::Data {
    std::vector<SeriesDef> series;
    std::map<QString, MapDef> maps;
    std::vector<ModelEntry> models;
    std::vector<FirmwareDef> firmware;
};
} // namespace catalog
