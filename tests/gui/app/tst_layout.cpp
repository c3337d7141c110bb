// SPDX-License-Identifier: GPL-3.0-or-later
// The window at its smallest useful size, in both languages, in its own font, in a larger font and
// in the font of a new machine: nothing is cut off without a tooltip that has the rest, and every
// control has a name for people, for screen readers and for tests.
#include "gui/main_window_fixture.h"
#include "support/test_main.h"
#include "support/test_paths.h"
#include "ui/app/pages.h"
#include "ui/memory/memory_text.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialog>
#include <QFontDatabase>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTableView>
#include <QTreeView>

using ui::MemoryColumn;

namespace {
QString displayName(const QWidget& widget)
{
    QString path;
    for (const QWidget* w = &widget; w != nullptr && !w->isWindow(); w = w->parentWidget()) {
        const QString name = w->objectName().isEmpty()
                                 ? QString::fromLatin1(w->metaObject()->className())
                                 : w->objectName();
        path.prepend(QLatin1Char('/') + name);
    }
    return path;
}

/// Qt's own parts of larger widgets are named by those.
bool isInternalChild(const QWidget& widget)
{
    const QWidget* parent = widget.parentWidget();
    return widget.objectName().startsWith(QLatin1String("qt_")) ||
           qobject_cast<const QAbstractSpinBox*>(parent) != nullptr ||
           qobject_cast<const QComboBox*>(parent) != nullptr ||
           qobject_cast<const QLineEdit*>(parent) != nullptr ||
           qobject_cast<const QTabBar*>(parent) != nullptr ||
           (parent != nullptr && parent->inherits("QMenuBar")) ||
           (parent != nullptr && parent->inherits("QToolBar") &&
            widget.inherits("QToolBarExtension")) ||
           widget.inherits("QComboBoxListView") || widget.inherits("QDockWidgetTitleButton") ||
           widget.inherits("QTableCornerButton");
}

bool isInteractive(const QWidget& widget)
{
    return qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
           qobject_cast<const QLineEdit*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
           qobject_cast<const QComboBox*>(&widget) != nullptr ||
           (qobject_cast<const QAbstractItemView*>(&widget) != nullptr &&
            qobject_cast<const QHeaderView*>(&widget) == nullptr);
}

/// The text of a label or button that does not fit.
QString isTruncated(const QWidget& widget)
{
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        if (label->text().isEmpty() || !label->toolTip().isEmpty())
            return {};
        const int wanted =
            label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
        const bool narrow = !label->wordWrap() && label->width() < label->sizeHint().width();
        return narrow || label->height() < wanted ? label->text() : QString();
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        const QSize hint = button->minimumSizeHint().isValid()
                               ? button->minimumSizeHint().boundedTo(button->sizeHint())
                               : button->sizeHint();
        const bool small = button->width() < hint.width() || button->height() < hint.height() - 1;
        return !button->text().isEmpty() && small ? button->text() : QString();
    }
    return {};
}

QStringList elidedHeaders(const QHeaderView& header)
{
    QStringList cut;
    if (header.orientation() != Qt::Horizontal || header.model() == nullptr || header.isHidden())
        return cut;
    for (int i = 0; i < header.count(); ++i) {
        const QString text = header.model()->headerData(i, Qt::Horizontal).toString();
        const int wanted = QFontMetrics(header.font()).horizontalAdvance(text);
        const bool tip =
            !header.model()->headerData(i, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty();
        if (!header.isSectionHidden(i) && header.sectionSize(i) < wanted && !tip)
            cut << text;
    }
    return cut;
}

/// Names and physical values of the memory table that do not fit their cell, wrapped or not.
QStringList cutCells(const QTableView& table)
{
    constexpr int margins = 8;
    const QFontMetrics metrics(table.font());
    QStringList cut;
    for (int row = 0; row < table.model()->rowCount(); ++row) {
        for (const auto column : {MemoryColumn::Name, MemoryColumn::Physical}) {
            const QModelIndex cell = table.model()->index(row, static_cast<int>(column));
            const QString text = cell.data().toString();
            const QRect room(0, 0, table.columnWidth(cell.column()) - margins, 1000);
            const QSize needed = metrics.boundingRect(room, Qt::TextWordWrap, text).size();
            if (!text.isEmpty() &&
                (needed.width() > room.width() || needed.height() > table.rowHeight(row)))
                cut << text;
        }
    }
    return cut;
}

/// Cells whose text is wider than the cell, without the whole text in a tooltip.
QStringList elidedCellsWithoutTooltip(const QAbstractItemView& view)
{
    QStringList silent;
    const QAbstractItemModel* model = view.model();
    if (model == nullptr)
        return silent;
    for (int row = 0; row < model->rowCount(); ++row) {
        for (int column = 0; column < model->columnCount(); ++column) {
            const QModelIndex index = model->index(row, column);
            const QString text = index.data(Qt::DisplayRole).toString();
            const QRect rect = view.visualRect(index);
            const int wanted = QFontMetrics(view.font()).horizontalAdvance(text);
            if (rect.width() > 0 && wanted > rect.width() &&
                index.data(Qt::ToolTipRole).toString().isEmpty())
                silent << text;
        }
    }
    return silent;
}
QStringList elidedWidgets(const QWidget& window)
{
    QStringList faults;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible() || isInternalChild(*widget))
            continue;
        if (const QString text = isTruncated(*widget); !text.isEmpty())
            faults << displayName(*widget) + QStringLiteral(": ") + text;
        if (const auto* header = qobject_cast<const QHeaderView*>(widget)) {
            for (const QString& text : elidedHeaders(*header))
                faults << displayName(*widget) + QStringLiteral(": header ") + text;
        } else if (const auto* view = qobject_cast<const QAbstractItemView*>(widget)) {
            for (const QString& text : elidedCellsWithoutTooltip(*view))
                faults << displayName(*widget) + QStringLiteral(": cell ") + text;
        }
    }
    return faults;
}

} // namespace

class TestLayout : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        m_font = QApplication::font();
        for (const char* file : {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"})
            QVERIFY(QFontDatabase::addApplicationFont(QStringLiteral(DEJAVU_FONTS "/") +
                                                      QLatin1String(file)) >= 0);
    }
    void init() { gui::failOnWarnings(); }
    void cleanup()
    {
        gui::fontOverride.reset();
        QApplication::setFont(m_font);
    }

    void nothingIsCutOff_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("port");
        QTest::addColumn<QString>("page");
        QTest::addColumn<QString>("family"); // empty: the program's own
        QTest::addColumn<double>("size");
        const QString english = QStringLiteral("en");
        const QString chinese = QStringLiteral("zh_CN");
        const QString memory = QStringLiteral("memory");
        const QString operate = QStringLiteral("operate");
        struct FontCase {
            const char* name;
            const char* family;
            double size;
        };
        for (const FontCase& letters : {FontCase{"own font", "", 1}, FontCase{"120 %", "", 1.2},
                                        FontCase{"DejaVu", "DejaVu Sans", 1}}) {
            const auto row = [&](const char* what, const QString& language, const char* port,
                                 const QString& page) {
                QTest::addRow("%s, %s, %s", what, qPrintable(page), letters.name)
                    << language << QString::fromLatin1(port) << page
                    << QString::fromLatin1(letters.family) << letters.size;
            };
            row("English, no port", english, "", memory);
            row("Chinese, no port", chinese, "", memory);
            for (const char* page :
                 {"sweep", "step", "snapshots", "commission", "arm", "firmware", "history"}) {
                row("English, STS", english, "sim:demo", QString::fromLatin1(page));
                row("Chinese, STS", chinese, "sim:demo", QString::fromLatin1(page));
            }
            for (const QString& page : {memory, operate}) {
                row("English, STS", english, "sim:demo", page);
                row("Chinese, STS", chinese, "sim:demo", page);
                row("English, SCS", english, "sim:scs15@1", page);
                row("Chinese, HLS", chinese, "sim:hls3625@1", page);
                row("English, LX", english, "sim:lx", page);
                row("Chinese, Modbus", chinese, "sim:modbus", page);
            }
        }
    }
    void nothingIsCutOff()
    {
        QFETCH(QString, language);
        QFETCH(QString, port);
        QFETCH(QString, page);
        QFETCH(QString, family);
        QFETCH(double, size);
        QFont font = m_font;
        font.setPointSizeF(m_font.pointSizeF() * size);
        QApplication::setFont(font);
        if (!family.isEmpty()) {
            font.setFamilies({family});
            gui::fontOverride = font;
        }
        gui::MainWindowFixture fixture(language);
        QCOMPARE(QFontInfo(fixture.window->font()).family(),
                 family.isEmpty() ? QStringLiteral("Noto Sans") : family);
        fixture.page = page;
        fixture.window->resize(1024, 700);
        if (!port.isEmpty())
            QVERIFY(fixture.ready(1, port) && fixture.waitUntilIdle());
        QVERIFY(QTest::qWaitForWindowExposed(fixture.window.get()));
        QCOMPARE(fixture.window->size(), QSize(1024, 700));
        QString faults;
        const auto nothing = [&] {
            faults = elidedWidgets(*fixture.window).join(QLatin1Char('\n'));
            return faults.isEmpty();
        };
        // A widget with a new text is resized in the next turn of the event loop.
        QVERIFY2(support::waitFor(nothing), qPrintable(faults));
    }

    void theDefaultWindowShowsEveryColumn_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << "en";
        QTest::newRow("Chinese") << "zh_CN";
    }
    void theDefaultWindowShowsEveryColumn()
    {
        QFETCH(QString, language);
        gui::MainWindowFixture fixture(language);
        QVERIFY(fixture.ready(1));
        const auto* table = fixture.find<QTableView>("memoryTable");
        for (int column = 0; column < table->model()->columnCount(); ++column)
            QVERIFY2(!table->isColumnHidden(column), qPrintable(QString::number(column)));
    }

    /// At any width: lists of flags and long names get a second line.
    void namesAndValuesOfTheTableAreWhole_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QSize>("size");
        for (const char* language : {"en", "zh_CN"}) {
            for (const QSize size : {QSize(1024, 700), QSize(1280, 800), QSize(1920, 1080)})
                QTest::addRow("%s, %d", language, size.width()) << language << size;
        }
    }
    void namesAndValuesOfTheTableAreWhole()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        gui::MainWindowFixture fixture(language);
        fixture.page = QStringLiteral("memory");
        fixture.window->resize(size);
        QVERIFY(fixture.ready(1));
        const auto* table = fixture.find<QTableView>("memoryTable");
        const auto isRead = [&] { // a list of flags is there
            return !table->model()
                        ->match(table->model()->index(0, static_cast<int>(MemoryColumn::Physical)),
                                Qt::DisplayRole, QStringLiteral(" + "), 1, Qt::MatchContains)
                        .isEmpty();
        };
        QVERIFY(support::waitFor(isRead));
        QStringList cut;
        const auto nothing = [&] {
            cut = cutCells(*table);
            return table->isVisible() && cut.isEmpty();
        };
        QVERIFY2(support::waitFor(nothing), qPrintable(cut.join(QLatin1Char('\n'))));
        fixture.find<QLineEdit>("registerFind")
            ->setText(QStringLiteral("e")); // other rows come and go
        QVERIFY2(support::waitFor(nothing), qPrintable(cut.join(QLatin1Char('\n'))));
        fixture.find<QLineEdit>("registerFind")->clear();
        QVERIFY2(support::waitFor(nothing), qPrintable(cut.join(QLatin1Char('\n'))));
    }

    void theDefaultWindowNeedsNoScrolling_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("port");
        for (const char* language : {"en", "zh_CN"}) {
            for (const char* port : {"sim:demo", "sim:scs15@1", "sim:hls3625@1", "sim:lx"})
                QTest::addRow("%s, %s", language, port) << language << port;
        }
    }
    void theDefaultWindowNeedsNoScrolling()
    {
        QFETCH(QString, language);
        QFETCH(QString, port);
        gui::MainWindowFixture fixture(language);
        fixture.page = QStringLiteral("operate");
        fixture.window->resize(1280, 800);
        QVERIFY(fixture.ready(1, port));
        const QScrollBar* bar = fixture.find<QScrollArea>("controlScroll")->verticalScrollBar();
        QTRY_VERIFY(fixture.find<QPushButton>("setGoal")->isVisible());
        QVERIFY(fixture.waitUntilIdle()); // the fields are there when the table has been read
        if (port != QLatin1String("sim:lx"))
            QTRY_VERIFY(fixture.find<QWidget>("speed")->isVisible());
        QTRY_COMPARE(bar->maximum(), 0);
        const QWidget* find = fixture.find<QWidget>("registerFind");
        fixture.window->findChild<ui::Pages*>()->open(QStringLiteral("memory"));
        QTRY_VERIFY(find->isVisible());
        const QWidget* last = fixture.find<QWidget>("memoryMore");
        QVERIFY2(std::abs(last->geometry().center().y() - find->geometry().center().y()) <= 2,
                 "the toolbar of the memory page has a second row");
    }

    /// The dial gives way.
    void theMotionPanelFitsASmallWindow_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << "en";
        QTest::newRow("Chinese") << "zh_CN";
    }
    void theMotionPanelFitsASmallWindow()
    {
        QFETCH(QString, language);
        gui::MainWindowFixture fixture(language);
        fixture.page = QStringLiteral("operate");
        fixture.window->resize(1024, 700);
        QVERIFY(fixture.ready(1, QStringLiteral("sim:demo")));
        QTRY_VERIFY(fixture.find<QPushButton>("setGoal")->isVisible());
        QVERIFY(fixture.waitUntilIdle()); // the fields are there when the table has been read
        QTRY_VERIFY(fixture.find<QWidget>("speed")->isVisible());
        QTRY_COMPARE(fixture.find<QScrollArea>("controlScroll")->verticalScrollBar()->maximum(), 0);
    }

    /// Every dialog that opens without a change to a servo.
    void dialogsFit_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<double>("size");
        QTest::newRow("English") << "en" << 1.0;
        QTest::newRow("Chinese") << "zh_CN" << 1.0;
        QTest::newRow("English, 120 %") << "en" << 1.2;
    }
    void dialogsFit()
    {
        QFETCH(QString, language);
        QFETCH(double, size);
        QFont font = m_font;
        font.setPointSizeF(m_font.pointSizeF() * size);
        QApplication::setFont(font);
        gui::MainWindowFixture fixture(language);
        fixture.window->resize(1024, 700);
        QVERIFY(fixture.ready(1));
        QVERIFY(fixture.waitUntilIdle());
        QStringList faults;
        const auto check = [&](const QString& name) {
            QDialog* dialog = nullptr;
            const auto opened = [&] {
                for (auto* one : fixture.window->findChildren<QDialog*>()) {
                    if (one->isVisible())
                        dialog = one;
                }
                return dialog != nullptr;
            };
            if (!support::waitFor(opened)) {
                faults << name + QStringLiteral(": no dialog");
                return;
            }
            QStringList cut;
            if (!support::waitFor([&] { return (cut = elidedWidgets(*dialog)).isEmpty(); }))
                faults << name + QStringLiteral(": ") + cut.join(QStringLiteral("; "));
            if (!QRect(0, 0, 1024, 700).contains(QRect(QPoint(), dialog->size())))
                faults << QStringLiteral("%1: %2 × %3")
                              .arg(name)
                              .arg(dialog->width())
                              .arg(dialog->height());
            dialog->reject();
            QVERIFY(support::waitFor([&] {
                return !fixture.window->findChildren<QDialog*>().contains(dialog) ||
                       !dialog->isVisible();
            }));
        };
        using ui::Command;
        for (const Command command :
             {Command::SetId, Command::SetBaud, Command::Center, Command::RestoreDefaults,
              Command::Reboot, Command::Identify, Command::PreviousTests, Command::Record,
              Command::Shortcuts, Command::About}) {
            fixture.action(command)->trigger();
            check(fixture.action(command)->text());
        }
        const std::pair<const char*, const char*> buttons[] = {{"history", "historyServer"},
                                                               {"sweep", "sweepLimits"},
                                                               {"step", "stepEarlier"},
                                                               {"operate", "trendChannels"}};
        for (const auto& [page, name] : buttons) {
            fixture.window->findChild<ui::Pages*>()->open(QString::fromLatin1(page));
            auto* button = fixture.find<QAbstractButton>(name);
            QVERIFY2(button != nullptr, name);
            QTRY_VERIFY2(button->isEnabled(), name);
            button->click();
            check(QString::fromLatin1(name));
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    }

    void interactiveWidgetsHaveNames()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1));
        QStringList faults;
        int seen = 0;
        for (const QWidget* widget : fixture.window->findChildren<QWidget*>()) {
            if (!isInteractive(*widget) || isInternalChild(*widget))
                continue;
            ++seen;
            if (widget->objectName().isEmpty())
                faults << displayName(*widget) + QStringLiteral(": no object name");
            if (widget->accessibleName().isEmpty())
                faults << displayName(*widget) + QStringLiteral(": no accessible name");
            if (widget->toolTip().isEmpty())
                faults << displayName(*widget) + QStringLiteral(": no tooltip");
        }
        QVERIFY(seen > 20);
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    }

    void switchingToChineseLeavesNoEnglish()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1));
        fixture.setLanguage(QStringLiteral("zh_CN"));
        static const QRegularExpression sentence(
            QStringLiteral("\\b[A-Za-z]{3,} [a-z]{2,} [a-z]{2,}\\b"));
        QStringList faults;
        for (const QWidget* widget : fixture.window->findChildren<QWidget*>()) {
            QStringList texts{widget->toolTip(), widget->accessibleName()};
            if (const auto* label = qobject_cast<const QLabel*>(widget))
                texts << label->text();
            if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
                texts << button->text();
            for (const QString& text : texts) {
                if (text.contains(sentence))
                    faults << displayName(*widget) + QStringLiteral(": ") + text;
            }
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    }

private:
    QFont m_font; ///< of the platform
};

SERVODESK_TEST(TestLayout)
#include "tst_layout.moc"
