// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/sweep_goal_list.h"

#include "results/sweep_points.h"
#include "text/error_text.h"
#include "text/language.h"
#include "ui/common/file_dialog.h"

#include <QFileInfo>

namespace ui {
SweepGoalList::SweepGoalList(session::Settings& settings, QWidget* parent)
    : QPushButton(parent)
    , m_settings(settings)
{
    connect(this, &QPushButton::clicked, this, &SweepGoalList::open);
}

void SweepGoalList::open()
{
    askForFile(this,
               {QStringLiteral("sweepListDialog"),
                tr("Open a list of goals"),
                {tr("Goal lists (*.csv *.txt)"), tr("All files (*)")},
                {},
                &m_settings,
                QStringLiteral("sweep/list_folder")},
               [this](const QString& path) { read(path); });
}

void SweepGoalList::read(const QString& path)
{
    m_path = path;
    auto points = results::loadSweepPoints(path);
    m_points = points ? std::move(*points) : std::vector<results::SweepPoint>{};
    m_error.clear();
    if (!points) {
        const text::Description description = text::describe(points.error());
        m_error = text::joinSentences({description.message, description.remedy});
    }
    retranslate();
    Q_EMIT changed();
}

void SweepGoalList::retranslate()
{
    setText(m_path.isEmpty() || !m_error.isEmpty()
                ? tr("Open a list…")
                : tr("%1 (%n goal(s))", nullptr, int(m_points.size()))
                      .arg(QFileInfo(m_path).fileName()));
}
} // namespace ui
