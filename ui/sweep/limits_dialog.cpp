// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/limits_dialog.h"

#include "report/sweep_text.h"
#include "text/error_text.h"
#include "text/language.h"
#include "ui/common/dialog_sizes.h"
#include "ui/common/file_dialog.h"
#include "ui/common/follow_language.h"
#include "ui/common/theme.h"
#include "ui/common/widget_style.h"
#include "ui/sweep/limits_delegate.h"
#include "ui/sweep/limits_model.h"

#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QThread>
#include <QVBoxLayout>

namespace ui {
using results::SweepLimits;

namespace {
/// `work` on a thread of its own; its result comes back on the dialog's, if that is still there.
template <typename Work, typename Then>
void runInThread(QObject* home, Work work, Then then)
{
    using Result = decltype(work());
    const auto result = std::make_shared<std::optional<Result>>();
    QThread* thread = QThread::create([work, result] { *result = work(); });
    QObject::connect(thread, &QThread::finished, home, [result, then] { then(**result); });
    QObject::connect(thread, &QThread::finished, thread, &QObject::deleteLater);
    thread->start();
}

QPushButton* button(QWidget* parent, const char* name)
{
    auto* one = new QPushButton(parent);
    one->setObjectName(QString::fromLatin1(name));
    one->setAutoDefault(false);
    return one;
}
} // namespace

LimitsDialog::LimitsDialog(session::Settings& settings, const SweepLimits& limits,
                           const QString& model, const QString& series, QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
    , m_model(model)
    , m_series(series)
    , m_lines(new LimitsModel(this))
{
    setObjectName(QStringLiteral("limitsDialog"));
    rememberSize(*this);
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connectAll();
    followLanguage(this, [this] { retranslate(); });
    setLimits(limits);
    resize(fontMetrics().averageCharWidth() * 96, fontMetrics().height() * 34);
}

void LimitsDialog::build()
{
    auto* column = new QVBoxLayout(this);
    m_form = new QFormLayout;
    const auto field = [this](const char* name) {
        auto* edit = new QLineEdit(this);
        edit->setObjectName(QString::fromLatin1(name));
        auto* label = new QLabel(this);
        label->setBuddy(edit);
        m_form->addRow(label, edit);
        return edit;
    };
    m_name = field("limitsName");
    m_models = field("limitsModels");
    m_tolerance = field("limitsTolerance");
    m_table = new QTableView(this);
    m_table->setObjectName(QStringLiteral("limitsTable"));
    m_table->setModel(m_lines);
    m_table->setItemDelegate(new LimitsDelegate(m_table));
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::SelectedClicked |
                             QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    styleTable(m_table);
    m_table->setSelectionBehavior(QAbstractItemView::SelectItems);
    m_table->setTabKeyNavigation(true);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(int(LimitColumn::Metric),
                                                      QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(int(LimitColumn::Unit),
                                                      QHeaderView::ResizeToContents);
    m_problem = new QLabel(this);
    m_problem->setObjectName(QStringLiteral("limitsTrouble"));
    m_problem->setWordWrap(true);
    m_problem->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    column->addLayout(m_form);
    column->addWidget(m_table, 1);
    column->addLayout(buildLineButtons());
    column->addWidget(m_problem);
    column->addLayout(buildButtons());
}

QLayout* LimitsDialog::buildLineButtons()
{
    m_add = button(this, "limitsAdd");
    m_remove = button(this, "limitsRemove");
    m_builtIn = button(this, "limitsBuiltIn");
    auto* row = new QHBoxLayout;
    row->addWidget(m_add);
    row->addWidget(m_remove);
    row->addStretch();
    row->addWidget(m_builtIn);
    return row;
}

QLayout* LimitsDialog::buildButtons()
{
    m_load = button(this, "limitsLoad");
    m_save = button(this, "limitsSave");
    m_cancel = button(this, "limitsCancel");
    m_use = button(this, "limitsUse");
    makeMainAction(m_use);
    auto* row = new QHBoxLayout;
    row->addWidget(m_load);
    row->addWidget(m_save);
    row->addStretch();
    row->addWidget(m_cancel);
    row->addWidget(m_use);
    return row;
}

void LimitsDialog::connectAll()
{
    for (QLineEdit* field : {m_name, m_models, m_tolerance})
        connect(field, &QLineEdit::textChanged, this, &LimitsDialog::refresh);
    connect(m_lines, &LimitsModel::edited, this, &LimitsDialog::refresh);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &LimitsDialog::refresh);
    connect(m_add, &QPushButton::clicked, this, &LimitsDialog::addLine);
    connect(m_remove, &QPushButton::clicked, this, &LimitsDialog::removeLine);
    connect(m_builtIn, &QPushButton::clicked, this,
            [this] { setLimits(results::builtInSweepLimits(m_model, m_series)); });
    connect(m_load, &QPushButton::clicked, this, [this] { askForFile(false); });
    connect(m_save, &QPushButton::clicked, this, [this] { askForFile(true); });
    connect(m_cancel, &QPushButton::clicked, this, &QDialog::close);
    connect(m_use, &QPushButton::clicked, this, [this] {
        Q_EMIT limitsAccepted(limits());
        close();
    });
}

void LimitsDialog::setLimits(const SweepLimits& limits)
{
    m_loadedName = limits.name;
    m_name->setText(text::localized(report::limitsName(m_loadedName)));
    m_models->setText(limits.models.join(QStringLiteral(", ")));
    m_tolerance->setText(
        limits.tolerance ? QString::number(*limits.tolerance, 'g', QLocale::FloatingPointShortest)
                         : QString());
    m_lines->setLines(limits.lines);
    if (m_lines->rowCount() > 0)
        m_table->setCurrentIndex(m_lines->index(0, int(LimitColumn::Warn)));
    refresh();
}

SweepLimits LimitsDialog::limits() const
{
    SweepLimits limits;
    limits.name = m_name->text().trimmed();
    const catalog::Text shown = report::limitsName(m_loadedName);
    if (limits.name == shown.en || limits.name == shown.zh)
        limits.name = m_loadedName;
    for (const QString& one : m_models->text().split(u',', Qt::SkipEmptyParts)) {
        if (!one.trimmed().isEmpty())
            limits.models << one.trimmed();
    }
    limits.tolerance = numberFromText(m_tolerance->text());
    limits.lines = m_lines->lines();
    return results::withNameOfItsOwn(limits, m_model);
}

QString LimitsDialog::problem() const
{
    if (m_name->text().trimmed().isEmpty())
        return tr("Enter a name for these limits; it appears in the report.");
    const auto tolerance = numberFromText(m_tolerance->text());
    if (!m_tolerance->text().trimmed().isEmpty() && (!tolerance || *tolerance <= 0))
        return tr("Enter a tolerance greater than 0 steps, or leave the field empty.");
    if (m_lines->rowCount() == 0)
        return tr("Add at least one limit; without limits, every servo would pass.");
    for (int row = 0; row < m_lines->rowCount(); ++row) {
        const QString wrong = m_lines->problem(row);
        if (!wrong.isEmpty())
            return tr("Row %1, %2: %3")
                .arg(row + 1)
                .arg(m_lines->index(row, int(LimitColumn::Metric)).data().toString(), wrong);
    }
    return {};
}

void LimitsDialog::refresh()
{
    const QString wrong = problem();
    showResult(wrong, true);
    for (QPushButton* one : {m_use, m_save})
        one->setEnabled(wrong.isEmpty());
    m_use->setToolTip(wrong.isEmpty() ? tr("Uses these limits from now on") : wrong);
    m_save->setToolTip(wrong.isEmpty() ? tr("Saves these limits to a file") : wrong);
    m_remove->setEnabled(m_table->currentIndex().isValid());
}

void LimitsDialog::showResult(const QString& words, bool bad)
{
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, tone(bad ? Tone::Bad : Tone::Good, palette()));
    m_problem->setPalette(colors);
    const QString sign = bad ? QStringLiteral("✘ ") : QStringLiteral("✔ ");
    m_problem->setText(words.isEmpty() ? QString() : sign + words);
    m_problem->setVisible(!words.isEmpty());
}

void LimitsDialog::addLine()
{
    const QModelIndex fresh = m_lines->index(m_lines->add(), int(LimitColumn::Metric));
    m_table->setCurrentIndex(fresh);
    m_table->setFocus();
}

void LimitsDialog::removeLine()
{
    m_lines->remove(m_table->currentIndex().row());
    refresh();
}

void LimitsDialog::askForFile(bool saving)
{
    FileRequest request{QStringLiteral("loadLimitsDialog"),
                        tr("Load limits"),
                        {tr("Limits (*.json)"), tr("All files (*)")},
                        {},
                        &m_settings,
                        QStringLiteral("sweep/limits_folder")};
    if (!saving) {
        ui::askForFile(this, request, [this](const QString& path) { load(path); });
        return;
    }
    request.objectName = QStringLiteral("saveLimitsDialog");
    request.title = tr("Save limits");
    askForSavePath(this, request, [this](const QString& path) { save(path); });
}

void LimitsDialog::load(const QString& path)
{
    runInThread(
        this, [path] { return results::loadSweepLimits(path); },
        [this, path](const base::Result<SweepLimits>& limits) {
            if (!limits) {
                onFileError(limits.error());
                return;
            }
            setLimits(*limits);
            Q_EMIT loaded(path);
        });
}

void LimitsDialog::save(const QString& path)
{
    const SweepLimits kept = limits();
    runInThread(
        this, [kept, path] { return results::saveSweepLimits(kept, path); },
        [this, path](const base::Result<void>& done) {
            if (!done) {
                onFileError(done.error());
                return;
            }
            showResult(tr("Saved to %1").arg(QDir::toNativeSeparators(path)), false);
            Q_EMIT saved(path);
        });
}

void LimitsDialog::onFileError(const base::Error& error)
{
    const text::Description words = text::describe(error);
    showResult(text::joinSentences({words.message, words.remedy}), true);
}

void LimitsDialog::retranslate()
{
    setWindowTitle(tr("Sweep test limits"));
    const auto label = [this](QWidget* field, const QString& text, const QString& tip) {
        static_cast<QLabel*>(m_form->labelForField(field))->setText(text);
        field->setAccessibleName(text);
        field->setToolTip(tip);
    };
    label(m_name, tr("Name"), tr("Appears in the report"));
    label(m_models, tr("Models"),
          tr("Models or families that these limits apply to, separated by commas; leave empty for "
             "any"));
    label(
        m_tolerance, tr("Tolerance, steps"),
        tr("A goal counts as reached within this distance; leave empty to use the family default"));
    m_models->setPlaceholderText(tr("any"));
    m_tolerance->setPlaceholderText(tr("family default"));
    m_table->setAccessibleName(tr("Limits"));
    m_table->setToolTip(tr("One row per limit; type or press F2 to change a value"));
    const auto setTexts = [](QPushButton* one, const QString& text, const QString& tip) {
        one->setText(text);
        one->setAccessibleName(text);
        one->setToolTip(tip);
    };
    setTexts(m_add, tr("Add limit"), tr("Adds a limit for another metric"));
    setTexts(m_remove, tr("Remove limit"), tr("Removes the selected limit"));
    setTexts(m_builtIn, tr("Load built-in limits"),
             tr("Loads the limits that come with the program"));
    setTexts(m_load, tr("Load…"), tr("Load limits"));
    setTexts(m_save, tr("Save as…"), QString());
    setTexts(m_cancel, tr("Cancel"), tr("Discards the changes"));
    setTexts(m_use, tr("Use these limits"), QString());
    m_lines->retranslate();
    refresh();
}
} // namespace ui
