// SPDX-License-Identifier: GPL-3.0-or-later
// Which firmware file: its name, and the button that asks for another one. Owned by its dialog;
// main thread. A file that is none for bus servos is told by its error, and no file is chosen then.
#pragma once

#include "jobs/firmware/firmware_file.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace session {
class Settings;
}

namespace ui {
class FirmwareFileRow final : public QWidget {
    Q_OBJECT

public:
    explicit FirmwareFileRow(session::Settings& settings, QWidget* parent = nullptr);

    const std::optional<jobs::FirmwareFile>& file() const { return m_file; }

Q_SIGNALS:
    void changed();
    void failed(const base::Error& error);

protected:
    void changeEvent(QEvent* event) override;

private:
    void choose();
    void load(const QString& path);
    void retranslate();

    session::Settings& m_settings;
    std::optional<jobs::FirmwareFile> m_file;
    QLabel* m_name;
    QPushButton* m_choose;
};
} // namespace ui
