// SPDX-License-Identifier: GPL-3.0-or-later
// Which firmware the servos of the list run, which differ from the others, and which newer version
// is known. Reads nothing from the servos: the search has read their versions. Owned by the window;
// main thread.
#pragma once

#include "session/settings.h"
#include "ui/common/app_context.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QTableWidget;

namespace ui {
class Banner;
class Selection;

class FirmwarePage final : public QWidget {
    Q_OBJECT

public:
    FirmwarePage(AppContext& context, session::Settings& settings, QWidget* parent = nullptr);

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct Row;

    void build();
    void update();
    std::vector<Row> rows() const;
    void showRows(const std::vector<Row>& rows);
    QString summary(const std::vector<Row>& rows) const;
    void save();
    void selectServos();
    void retranslate();

    session::Workbench& m_workbench;
    session::Settings& m_settings;
    Selection& m_selection;
    const Commands& m_commands;
    QLabel* m_title;
    QLabel* m_summary;
    Banner* m_banner;
    QTableWidget* m_table;
    QLabel* m_emptyLabel;
    QLabel* m_source;
    QPushButton* m_rescue;
    QPushButton* m_update;
    QPushButton* m_save;
};
} // namespace ui
