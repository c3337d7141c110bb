// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/compare_dialog.h"

#include "report/html_page.h"
#include "report/register_name.h"
#include "report/sweep_compare_html.h"
#include "report/sweep_compare_text.h"
#include "text/language.h"
#include "ui/common/dialog_sizes.h"
#include "ui/common/file_dialog.h"
#include "ui/common/widget_style.h"
#include "ui/widgets/test_text.h"
#include "ui/widgets/tone_delegate.h"

#include <QDir>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace ui {
namespace {
constexpr int compareWidth = 900;
constexpr int compareHeight = 640;
constexpr int tableHeight = 150;

results::SweepSide sideOf(const CompareSide& side)
{
    return {side.name, *side.run, *results::servoOf(*side.run, side.servo)};
}

QString in(const report::Text& words)
{
    return text::localized(words);
}

void setCell(QTableWidget* table, int row, int column, const QString& words,
             std::optional<Tone> tone = {})
{
    auto* item = new QTableWidgetItem(words);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    item->setToolTip(words);
    if (tone)
        item->setData(toneRole, static_cast<int>(*tone));
    table->setItem(row, column, item);
}

void setNumber(QTableWidget* table, int row, int column, const QString& words)
{
    setCell(table, row, column, words);
    table->item(row, column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

void setGrade(QTableWidget* table, int row, int column, const std::optional<results::Grade>& grade)
{
    if (grade)
        setCell(table, row, column, lineGradeText(*grade), gradeTone(*grade));
    else
        setCell(table, row, column, QString());
}

/// No higher than its rows, so that the figures have the room.
void limitHeight(QTableWidget* table)
{
    table->resizeColumnsToContents();
    const int rows = table->rowCount() * table->verticalHeader()->defaultSectionSize();
    const int all = table->horizontalHeader()->sizeHint().height() + rows + 2 * table->frameWidth();
    table->setFixedHeight(std::min(all, tableHeight));
}

void setUpTable(QTableWidget* table, const char* name)
{
    table->setObjectName(QLatin1String(name));
    table->setItemDelegate(new ToneDelegate(table));
    styleTable(table);
    table->horizontalHeader()->setStretchLastSection(true);
}
} // namespace

CompareDialog::CompareDialog(session::HistoryService& historyService, session::Settings& settings,
                             const CompareSide& a, const CompareSide& b, QWidget* parent)
    : QDialog(parent)
    , m_historyService(historyService)
    , m_settings(settings)
    , m_a(a)
    , m_b(b)
    , m_found(results::compareSweeps(sideOf(a), sideOf(b)))
    , m_sides(new QLabel(this))
    , m_warnings(new QLabel(this))
    , m_tests(new QTableWidget(0, 3, this))
    , m_figures(new QTableWidget(0, 8, this))
    , m_settingsTitle(new QLabel(this))
    , m_settingsTable(new QTableWidget(0, 4, this))
    , m_result(new TaskResult(compareWidth - 2 * dialogMargin, this))
    , m_save(new QPushButton(this))
    , m_close(new QPushButton(this))
{
    setObjectName(QStringLiteral("compareDialog"));
    rememberSize(*this);
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(m_save, &QPushButton::clicked, this, &CompareDialog::askForSavePath);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    retranslate();
}

void CompareDialog::build()
{
    m_sides->setObjectName(QStringLiteral("compareSides"));
    m_sides->setTextFormat(Qt::PlainText);
    m_sides->setWordWrap(true);
    m_warnings->setObjectName(QStringLiteral("compareWarnings"));
    m_warnings->setWordWrap(true);
    m_settingsTitle->setObjectName(QStringLiteral("compareSettingsTitle"));
    m_settingsTitle->setWordWrap(true);
    setUpTable(m_tests, "compareTests");
    setUpTable(m_figures, "compareFigures");
    setUpTable(m_settingsTable, "compareSettings");
    auto* row = new QHBoxLayout;
    m_save->setObjectName(QStringLiteral("compareSave"));
    m_close->setObjectName(QStringLiteral("compareClose"));
    m_save->setAutoDefault(false);
    row->addWidget(m_save);
    row->addStretch();
    row->addWidget(m_close);
    auto* column = new QVBoxLayout(this);
    column->setSizeConstraint(QLayout::SetNoConstraint);
    for (QWidget* widget : {static_cast<QWidget*>(m_sides), static_cast<QWidget*>(m_warnings),
                            static_cast<QWidget*>(m_tests)})
        column->addWidget(widget);
    column->addWidget(m_figures, 1);
    column->addWidget(m_settingsTitle);
    column->addWidget(m_settingsTable);
    column->addWidget(m_result);
    column->addLayout(row);
    setMinimumSize(compareWidth, compareHeight);
}

void CompareDialog::retranslate()
{
    setWindowTitle(in(report::compareTexts().title));
    setAccessibleName(windowTitle());
    const auto setTexts = [](QWidget* widget, const QString& name, const QString& tip) {
        widget->setAccessibleName(name);
        widget->setToolTip(tip);
    };
    m_save->setText(tr("Save as web page…"));
    setTexts(m_save, m_save->text(), tr("Saves the comparison as a bilingual web page"));
    m_close->setText(tr("Close"));
    setTexts(m_close, m_close->text(), tr("Closes this comparison"));
    setTexts(m_tests, in(report::compareTexts().warnings), tr("Differences between the two tests"));
    setTexts(m_figures, tr("Metrics"),
             tr("Compares the metrics of both servos; the difference is B minus A"));
    setTexts(m_settingsTable, in(report::compareTexts().settings),
             tr("Settings that differed at the start of the tests"));
    fillSides();
    fillWarnings();
    fillFigures();
    fillSettings();
}

void CompareDialog::fillSides()
{
    const auto line = [](const char* letter, const CompareSide& of) {
        const results::SweepSide side = sideOf(of);
        const snapshot::SnapshotServo& identity = side.servo.parameters.servo;
        QStringList parts{tr("test %1").arg(side.name), identity.model,
                          tr("ID %1").arg(identity.id), tr("firmware %1").arg(identity.firmware)};
        if (!side.servo.parameters.label.isEmpty())
            parts << QString(side.servo.parameters.label).simplified();
        parts << side.run.at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"))
              << gradeText(side.servo.verdict);
        return QLatin1String(letter) + QStringLiteral(": ") + parts.join(QStringLiteral(" · "));
    };
    m_sides->setText(line("A", m_a) + QLatin1Char('\n') + line("B", m_b));
}

void CompareDialog::fillWarnings()
{
    const report::CompareTexts& words = report::compareTexts();
    const auto has = [&](results::DifferenceImpact weight) {
        return std::any_of(m_found.tests.begin(), m_found.tests.end(),
                           [&](const auto& one) { return one.weight == weight; });
    };
    QStringList lines;
    if (!m_found.comparable())
        lines << QStringLiteral("⚠ ") + in(words.notComparable);
    if (has(results::DifferenceImpact::Figure))
        lines << QStringLiteral("⚠ ") + in(words.someDiffer);
    if (has(results::DifferenceImpact::Grade))
        lines << QStringLiteral("⚠ ") + in(words.gradesDiffer);
    if (lines.isEmpty())
        lines << QStringLiteral("✓ ") + in(words.sameTest);
    m_warnings->setText(lines.join(QLatin1Char('\n')));
    updateColors();
    m_tests->setVisible(!m_found.tests.empty());
    m_tests->setHorizontalHeaderLabels(
        {in(words.testPart), QStringLiteral("A"), QStringLiteral("B")});
    m_tests->setRowCount(int(m_found.tests.size()));
    int row = 0;
    for (const results::TestDifference& one : m_found.tests) {
        setCell(m_tests, row, 0, in(report::testItemText(one.item)));
        setCell(m_tests, row, 1, in(report::testValueText(one.item, one.a)));
        setCell(m_tests, row++, 2, in(report::testValueText(one.item, one.b)));
    }
    limitHeight(m_tests);
}

void CompareDialog::updateColors()
{
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText,
                    tone(m_found.tests.empty() ? Tone::Good : Tone::Warn, palette()));
    m_warnings->setPalette(colors);
}

void CompareDialog::fillFigures()
{
    const report::CompareTexts& words = report::compareTexts();
    m_figures->setHorizontalHeaderLabels({tr("Metric"), QStringLiteral("A"), QStringLiteral("B"),
                                          in(words.difference), tr("Unit"), in(words.better),
                                          in(words.gradeA), in(words.gradeB)});
    m_figures->setRowCount(int(m_found.figures.size()));
    int row = 0;
    for (const results::FigureDifference& one : m_found.figures) {
        setCell(m_figures, row, 0, metricName(one.key));
        setNumber(m_figures, row, 1, sweepNumber(one.a));
        setNumber(m_figures, row, 2, sweepNumber(one.b));
        setNumber(m_figures, row, 3, report::differenceText(one));
        setCell(m_figures, row, 4, unitName(one.unit));
        setCell(m_figures, row, 5, report::betterSign(one));
        setGrade(m_figures, row, 6, one.gradeA);
        setGrade(m_figures, row++, 7, one.gradeB);
    }
    m_figures->resizeColumnsToContents();
}

void CompareDialog::fillSettings()
{
    const report::CompareTexts& words = report::compareTexts();
    const bool none = m_found.settings.empty();
    m_settingsTitle->setText(in(none ? words.noSettings : words.settings));
    m_settingsTable->setVisible(!none);
    m_settingsTable->setHorizontalHeaderLabels(
        {in(words.setting), QStringLiteral("A"), QStringLiteral("B"), tr("Unit")});
    m_settingsTable->setRowCount(int(m_found.settings.size()));
    int row = 0;
    for (const results::SettingDifference& one : m_found.settings) {
        setCell(m_settingsTable, row, 0,
                in(report::settingName(sideOf(m_a), sideOf(m_b), one.key)));
        setNumber(m_settingsTable, row, 1, sweepNumber(one.a));
        setNumber(m_settingsTable, row, 2, sweepNumber(one.b));
        setCell(m_settingsTable, row++, 3, in(report::registerUnit(one.unit)));
    }
    limitHeight(m_settingsTable);
}

void CompareDialog::askForSavePath()
{
    ui::askForSavePath(this,
                       {QStringLiteral("compareFileDialog"),
                        tr("Save the comparison"),
                        {tr("Web page (*.html)")},
                        QStringLiteral("sweep-%1-%2.html").arg(m_a.name, m_b.name),
                        &m_settings,
                        reportFolderKey()},
                       [this](const QString& path) { save(path); });
}

void CompareDialog::save(const QString& path)
{
    const bool chinese = text::isUiChinese();
    m_historyService.runInOrder(
        [a = m_a, b = m_b, chinese, path] {
            return report::saveSweepCompareHtml(sideOf(a), sideOf(b), chinese, path);
        },
        this,
        [this, path](const base::Result<void>& saved) {
            if (!saved) {
                m_result->showResult([error = saved.error()] { return errorText(error); });
                return;
            }
            m_result->showResult([path] {
                return TaskText{Tone::Good, tr("Saved: %1").arg(QDir::toNativeSeparators(path))};
            });
        });
}

void CompareDialog::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_close != nullptr)
        retranslate();
    else if (event->type() == QEvent::PaletteChange && m_close != nullptr)
        updateColors();
}
} // namespace ui
