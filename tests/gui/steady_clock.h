// SPDX-License-Identifier: GPL-3.0-or-later
// The clock of ui::PressGuard in tests. SteadyClock: whatever moved did so long ago, so that a test
// may press what it has just opened. PressClock: stands still until the test lets time pass.
#pragma once

#include "ui/widgets/press_guard.h"

namespace gui {
class SteadyClock final : public base::Clock {
public:
    SteadyClock() { ui::PressGuard::setClock(this); }
    ~SteadyClock() override { ui::PressGuard::setClock(nullptr); }
    SteadyClock(const SteadyClock&) = delete;
    SteadyClock& operator=(const SteadyClock&) = delete;

    base::Duration now() const override { return m_now += std::chrono::hours(1); }
    bool sleepUntil(base::Duration, const base::Stop*) override { return true; }

private:
    mutable base::Duration m_now{};
};

class PressClock final : public base::Clock {
public:
    PressClock() { ui::PressGuard::setClock(this); }
    ~PressClock() override { ui::PressGuard::setClock(nullptr); }
    PressClock(const PressClock&) = delete;
    PressClock& operator=(const PressClock&) = delete;

    base::Duration now() const override { return m_now; }
    bool sleepUntil(base::Duration, const base::Stop*) override { return true; }
    void pass(base::Duration time) { m_now += time; }

private:
    base::Duration m_now = std::chrono::hours(1);
};
} // namespace gui
