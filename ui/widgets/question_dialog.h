// SPDX-License-Identifier: GPL-3.0-or-later
// One question before an action that cannot easily be undone: what will happen, what can go wrong,
// and a button that names the action. Never blocks; the answer arrives in the callback, once, on
// the main thread. Enter and Esc mean "no", unless the question is harmless.
#pragma once

#include <QString>
#include <QWidget>

#include <functional>

namespace ui {
/// The texts in the language of the moment: the question keeps them while it is open.
struct Question {
    QString title;                    ///< window title and first line: "Write register 33?"
    QString text{};                   ///< what will happen
    QString risk{};                   ///< what can go wrong; shown with a warning sign
    QString acceptText;               ///< the action: "Write anyway"
    QString rejectText{};             ///< empty: "Cancel"
    bool acceptIsDefault = false;     ///< Enter means yes
    std::function<void()> rejected{}; ///< "no", Esc and closing; may be empty
    QString alternativeText{};        ///< a second way to go on; empty: there is none
    QString alternativeToolTip{};
    std::function<void()> alternativeAction{}; ///< when it is chosen
    /// Nothing is called when it has gone; the question closes then. Null pointer: no guard.
    QObject* guard = nullptr;
};

/// Opens it over `parent` and returns at once. The dialog's object name is "question", its buttons'
/// are "questionYes", "questionNo" and "questionOther".
void ask(QWidget* parent, const Question& question, std::function<void()> yes);
} // namespace ui
