// SPDX-License-Identifier: GPL-3.0-or-later
// Which arm the page shows: a built-in one, the user's file, or a new one, and the editor of its
// joints. Sets the arm of the calibration and remembers it for the next start. Owned by the arm
// page; main thread. A file that cannot be loaded is reported by failed(); the arm stays.
#pragma once

#include "base/error.h"
#include "jobs/arm/arm.h"

#include <QWidget>

class QComboBox;
class QPushButton;

namespace session {
class ArmCalibration;
class Settings;
} // namespace session

namespace ui {
class ArmChoice final : public QWidget {
    Q_OBJECT

public:
    ArmChoice(session::ArmCalibration& calibration, session::Settings& settings,
              QWidget* parent = nullptr);

    void setChangeable(bool isChangeable); ///< setEnabled() would disable open dialogs as well
    /// The arm of the last start, without loaded().
    void loadLast();

Q_SIGNALS:
    void loaded(); ///< the calibration has another arm
    void failed(const base::Error& error);

private:
    void choose(int index);
    void load(const QString& nameOrPath);
    void fill();
    void showChosen();
    bool isBuiltIn() const { return jobs::builtInArms().contains(m_key); }
    void edit();
    void openEditor(const jobs::Arm& arm, const QString& path);
    void retranslate();

    session::ArmCalibration& m_calibration;
    session::Settings& m_settings;
    QString m_key; ///< name of a built-in arm, or path of its file
    QComboBox* m_arms;
    QPushButton* m_edit;
};
} // namespace ui
