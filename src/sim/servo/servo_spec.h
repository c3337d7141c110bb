// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the servos of a bus from their specifications, for the presets and the list syntax.
// Fails with BadArgument when the catalog has no such model, it has no map to simulate, or the
// model does not know the rate.
#pragma once

#include "base/error.h"
#include "catalog/catalog.h"
#include "sim/bus/virtual_bus.h"

#include <functional>

namespace sim {
struct ServoSpec {
    QString model;
    int id = 1;
    std::optional<int> baud;           ///< the model's factory rate if not given
    std::optional<double> supplyVolts; ///< these three differ from servo to servo if not given
    std::optional<double> initialDegrees{};
    Load load;
    std::function<void(VirtualServo&)> prepare{}; ///< may be empty
    Defects defects{};
    std::optional<double> supplyOhms{};
    std::optional<double> ambientCelsius{};
    FirmwareBehavior behavior{};
    std::optional<base::Duration> epromTime{};
    std::optional<int> firmwareMinor{}; ///< that of the series if not given
};

base::Result<std::unique_ptr<VirtualBus>> makeBus(const std::vector<ServoSpec>& servoSpecs,
                                                  const catalog::Catalog& catalog,
                                                  const WireConfig& wire,
                                                  std::optional<base::Duration> epromTime);
} // namespace sim
