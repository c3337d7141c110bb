// SPDX-License-Identifier: GPL-3.0-or-later
// The reports in a real browser: no warnings, visible charts, both languages, which the buttons of
// the page switch. The browser starts twice: first a page around the reports examines them, then it
// makes a screenshot of a report.
#include "report/sweep_compare_html.h"
#include "report/sweep_html.h"
#include "support/test_main.h"
#include "support/text.h"
#include "unit/results/sweep_example.h"

#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

using support::utf8;

namespace {
constexpr QRgb traceColor = 0xff0b57d0;
constexpr int timeout = 120'000; ///< ms, for a browser that hangs

std::vector<report::SweepSeries> seriesWithGoalChange()
{
    report::SweepSeries series{5};
    for (int i = 0; i < 900; ++i)
        series.samples.push_back(
            {i * 0.01, 2000 + 1000 * std::sin(i * 0.02), i < 450 ? 3051. : 1000.});
    return {series};
}

bool write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

/// Examines each report: its first view, then after a click on each language.
const char* const probeScript = R"(<!DOCTYPE html><html><body>%1<pre id="found"></pre><script>
window.onload = async () => {
  const found = [];
  for (const frame of document.querySelectorAll('iframe')) {
    const page = frame.contentDocument;
    const shown = kind => [...page.querySelectorAll('h1 .' + kind)]
      .some(one => one.getClientRects().length > 0);
    const look = () => ({en: shown('en'), zh: shown('zh'),
      title: page.querySelector('h1').innerText});
    const first = look();
    page.getElementById('lang-zh').click();
    const chinese = look();
    page.getElementById('lang-en').click();
    const english = look();
    const charts = [...page.querySelectorAll('svg')].map(svg => {
      const box = svg.getBoundingClientRect();
      return {width: box.width, height: box.height,
        shapes: [...svg.querySelectorAll('path, rect, line')]
          .filter(one => one.getClientRects().length > 0).length};
    });
    await page.fonts.ready; // they load in parallel
    const fonts = [...page.fonts].filter(font => font.status === 'loaded')
      .map(font => font.family.replaceAll('\x22', '') + ' ' + font.weight);
    found.push({first, chinese, english, charts, fonts,
      wide: page.documentElement.scrollWidth > frame.clientWidth});
  }
  document.getElementById('found').textContent = JSON.stringify(found);
};
</script></body></html>)";
} // namespace

class TestReportBrowser : public QObject {
    Q_OBJECT

private:
    struct BrowserResult {
        int exit = -1;
        QByteArray out;
        QStringList complaints; ///< of the page's console
    };
    BrowserResult browse(const QStringList& options)
    {
        QProcess process;
        process.start(m_browser,
                      QStringList{utf8("--headless=new"), utf8("--no-sandbox"),
                                  utf8("--disable-gpu"), utf8("--disable-dev-shm-usage"),
                                  utf8("--no-first-run"), utf8("--disable-background-networking"),
                                  utf8("--hide-scrollbars"), utf8("--enable-logging=stderr"),
                                  utf8("--user-data-dir=") + m_folder.filePath(utf8("profile"))} +
                          options);
        BrowserResult result;
        if (!process.waitForFinished(timeout)) {
            process.kill();
            process.waitForFinished();
            return result;
        }
        result.exit = process.exitCode();
        result.out = process.readAllStandardOutput();
        for (const QByteArray& line : process.readAllStandardError().split('\n')) {
            if (line.contains("CONSOLE"))
                result.complaints << QString::fromUtf8(line);
        }
        return result;
    }
    QString page(const char* name) { return m_folder.filePath(utf8(name)); }

    QTemporaryDir m_folder;
    QString m_browser;

private Q_SLOTS:
    void initTestCase()
    {
        m_browser = QStandardPaths::findExecutable(utf8("chromium"));
        if (m_browser.isEmpty())
            QFAIL("there is no chromium here (packaging/test-packages.txt)");
        const results::SweepRun run = sweep_example::run();
        results::SweepRun other = run;
        other.servos[0].axis.to = 2000;
        const results::SweepSide a{utf8("12"), run, run.servos[0]};
        const results::SweepSide b{utf8("13"), other, other.servos[0]};
        QVERIFY(write(page("sweep.html"), report::sweepHtml(run, seriesWithGoalChange(), false)));
        QVERIFY(write(page("sweep-zh.html"), report::sweepHtml(run, seriesWithGoalChange(), true)));
        QVERIFY(write(page("compare.html"), report::sweepCompareHtml(a, b, false)));
    }

    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void chartsAndLanguages();
    void theCurveIsVisible();
};

void TestReportBrowser::chartsAndLanguages()
{
    QString frames;
    const QStringList names{utf8("sweep.html"), utf8("sweep-zh.html"), utf8("compare.html")};
    for (const QString& name : names)
        frames += utf8("<iframe width=\"1000\" height=\"900\" src=\"%1\"></iframe>").arg(name);
    QVERIFY(write(page("looker.html"), utf8(probeScript).arg(frames).toUtf8()));
    const BrowserResult result =
        browse({utf8("--allow-file-access-from-files"), utf8("--dump-dom"),
                utf8("--virtual-time-budget=60000"), utf8("file://") + page("looker.html")});
    QCOMPARE(result.exit, 0);
    QCOMPARE(result.complaints, QStringList());
    const int begin = result.out.indexOf("<pre id=\"found\">") + 16;
    const QByteArray json = result.out.mid(begin, result.out.indexOf("</pre>", begin) - begin);
    const QJsonArray found = QJsonDocument::fromJson(json).array();
    QCOMPARE(found.size(), names.size());
    for (int i = 0; i < found.size(); ++i) {
        const QJsonValue one = found[i];
        const bool chineseFirst = i == 1;
        QCOMPARE(one[utf8("first")][utf8("zh")].toBool(), chineseFirst);
        QCOMPARE(one[utf8("first")][utf8("en")].toBool(), !chineseFirst);
        QVERIFY(one[utf8("chinese")][utf8("zh")].toBool());
        QVERIFY(!one[utf8("chinese")][utf8("en")].toBool());
        QVERIFY(one[utf8("english")][utf8("en")].toBool());
        QVERIFY(!one[utf8("english")][utf8("zh")].toBool());
        QVERIFY(one[utf8("chinese")][utf8("title")].toString() !=
                one[utf8("english")][utf8("title")].toString());
        for (const char* font : {"ServoDesk Text 400", "ServoDesk Text 700", "ServoDesk Signs 400"})
            QVERIFY2(one[utf8("fonts")].toArray().contains(utf8(font)), font);
        QVERIFY(!one[utf8("wide")].toBool()); // nothing is cut off at the right
        const QJsonArray charts = one[utf8("charts")].toArray();
        QCOMPARE(charts.size(), 2);
        for (const QJsonValue& chart : charts) {
            QVERIFY(chart[utf8("width")].toDouble() > 500);
            QVERIFY(chart[utf8("height")].toDouble() > 150);
            QVERIFY(chart[utf8("shapes")].toInt() > 5);
        }
    }
}

/// From one side of its chart to the other.
void TestReportBrowser::theCurveIsVisible()
{
    const QString path = page("page.png");
    const BrowserResult result =
        browse({utf8("--window-size=1100,5000"), utf8("--screenshot=") + path,
                utf8("file://") + page("sweep.html")});
    QCOMPARE(result.exit, 0);
    QCOMPARE(result.complaints, QStringList());
    const QImage picture(path);
    QVERIFY(!picture.isNull());
    int left = picture.width();
    int right = 0;
    int pixels = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            if ((picture.pixel(x, y) | 0xff000000) != traceColor)
                continue;
            ++pixels;
            left = std::min(left, x);
            right = std::max(right, x);
        }
    }
    QVERIFY2(pixels > 1000, QByteArray::number(pixels));
    QVERIFY2(right - left > 500, QByteArray::number(right - left));
}

SERVODESK_GUILESS_TEST(TestReportBrowser)
#include "tst_report_browser.moc"
