// SPDX-License-Identifier: GPL-3.0-or-later
// The clock of ui::PressGuard in tests. AdvancingClock: every movement was long ago, so that a test
// can press what it has just opened. ManualPressClock: stops until the test lets time pass.
#pragma once

#include "ui/widgets/press_guard.h"

namespace gui {
class AdvancingClock final : public base::Clock {
public:
    AdvancingClock() { ui::PressGuard::setClock(this); }
    ~AdvancingClock() override { ui::PressGuard::setClock(nullptr); }
    AdvancingClock(const AdvancingClock&) = delete;
    AdvancingClock& operator=(const AdvancingClock&) = delete;

    base::Duration now() const override { return m_now += std::chrono::hours(1); }
    bool sleepUntil(base::Duration, const base::StopToken*) override { return true; }

private:
    mutable base::Duration m_now{};
};

class ManualPressClock final : public base::Clock {
public:
    ManualPressClock() { ui::PressGuard::setClock(this); }
    ~ManualPressClock() override { ui::PressGuard::setClock(nullptr); }
    ManualPressClock(const ManualPressClock&) = delete;
    ManualPressClock& operator=(const ManualPressClock&) = delete;

    base::Duration now() const override { return m_now; }
    bool sleepUntil(base::Duration, const base::StopToken*) override { return true; }
    void pass(base::Duration time) { m_now += time; }

private:
    base::Duration m_now = std::chrono::hours(1);
};
} // namespace gui
