// SPDX-License-Identifier: GPL-3.0-or-later
// The help of the program, in the language and theme of the window, from the Markdown files inside
// the program (resources/help). Open it with show(); it does not block, and deletes itself.
#pragma once

#include <QDialog>

class QTextBrowser;

namespace ui {
class HelpWindow final : public QDialog {
    Q_OBJECT

public:
    explicit HelpWindow(QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    void fill();

    QTextBrowser* m_text;
};
} // namespace ui
