// SPDX-License-Identifier: GPL-3.0-or-later
// All models and register maps, loaded once from JSON: the built-in resources first, then the
// user's folder. A bad row costs that row and one warning, not the start-up. Immutable after
// loading; any thread.
#pragma once

#include "catalog/profile.h"

#include <QDate>
#include <QStringList>

#include <memory>
#include <vector>

namespace catalog {
struct LoadWarning {
    QString file;
    QString where;  ///< "registers[12] position_p"
    QString detail; ///< untranslated
};

struct ModelEntry {
    int major = -1; ///< -1: number not known
    int minor = -1;
    QString name;
    QString series;
    base::ByteOrder byteOrder = base::ByteOrder::Little;
    Line line = Line::Unknown;
    int stepsPerTurn = 4096;
    std::optional<double> angleRangeDeg;
    std::optional<int> defaultBaud;
    std::optional<double> minVoltage;
    std::optional<double> maxVoltage;
    CurrentSensing currentSensing = CurrentSensing::Unknown;
    bool supported = true; ///< false: named by the vendor, no public map
    Text note;
};

/// A firmware version seen on a model. Informative: it need not be the latest.
struct KnownFirmware {
    int major = 0;
    int minor = 0;
    QDate date;              ///< when it was made
    QString source;          ///< where that is known from
    QString version() const; ///< "3.10"
};

class Catalog {
public:
    struct LoadResult;
    struct Data;

    Catalog(); ///< empty: every servo is unknown
    explicit Catalog(std::shared_ptr<const Data> data);

    /// Built-in files, then *.json of each folder in order; a later entry replaces an earlier one.
    static LoadResult load(const QStringList& userFolders = {});

    /// The profile for the values of registers 0–4. Never null: an unknown model with a known
    /// firmware gets a generic name; an unknown firmware gets a read-only profile (identity and
    /// feedback). Where firmware, byte order flag and model list contradict each other the profile
    /// has a conflict, and its table is bytes.
    ProfilePtr resolve(const Identity& identity) const;

    /// For files and the simulator: a model by its name; case, blanks and '-' are ignored
    /// ("lx16a"). Null if unknown.
    const ModelEntry* model(const QString& name) const;
    const std::vector<ModelEntry>& models() const;
    /// Profile of a model at a firmware, as the servo would report it.
    ProfilePtr profileFor(const ModelEntry& model, int firmwareMajor, int firmwareMinor) const;
    QStringList mapKeys() const;
    /// As the map itself names it, whatever the model; nullopt: no such map or register.
    std::optional<Text> registerName(const QString& mapKey, const QString& key) const;

    /// A firmware of this model that is newer than what the servo runs and keeps its register map.
    /// Only for known versions and identities that were really read.
    std::optional<KnownFirmware> newerFirmware(const Profile& profile) const;

    /// Any firmware of this model, or of its protocol where that has no model numbers: the vendor's
    /// file for it is named in `source`.
    std::optional<KnownFirmware> firmwareOf(const Profile& profile) const;

    /// The languages that can be met at this rate: Feetech always, then LX and Modbus if servos of
    /// theirs can be set to it or leave the factory with it.
    std::vector<base::Protocol> protocolsAt(int baud) const;

private:
    std::shared_ptr<const Data> m_data;
};

/// By place: which servos run another firmware than most of their model; of versions that are
/// equally frequent the newest counts. Null, and servos that report no version, never differ.
std::vector<bool> differingFirmware(const std::vector<ProfilePtr>& servos);

struct Catalog::LoadResult {
    Catalog catalog;
    std::vector<LoadWarning> warnings;
};
} // namespace catalog
