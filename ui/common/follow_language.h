// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps what a widget shows in the language that is set, without a changeEvent() of its own. Owned
// by the widget; main thread.
#pragma once

#include <functional>

class QWidget;

namespace ui {
/// Calls `show` now and after each change of language, before the same is done for its children.
void followLanguage(QWidget* widget, std::function<void()> show);
} // namespace ui
