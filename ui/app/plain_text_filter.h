// SPDX-License-Identifier: GPL-3.0-or-later
// Shows names, labels and notes from files and devices as they are: a label or tooltip whose text
// looks like HTML is not shown as HTML. Rich text must be declared by setTextFormat(). One object,
// owned by the application. Main thread.
#pragma once

#include <QObject>

namespace ui {
class PlainTextFilter final : public QObject {
    Q_OBJECT

public:
    /// For all labels from now on; again does nothing.
    static void install();

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    using QObject::QObject;
};
} // namespace ui
