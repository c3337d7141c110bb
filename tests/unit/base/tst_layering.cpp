// SPDX-License-Identifier: GPL-3.0-or-later
// Holds the sources against the table of layers in CONTRIBUTING.md: who includes whom, which Qt
// modules, and whether src/CMakeLists.txt links the same.
#include "support/test_main.h"
#include "support/test_paths.h"

#include <QDirIterator>
#include <QLibraryInfo>
#include <QRegularExpression>
#include <QtTest>

namespace {
struct Layer {
    QString name;
    QStringList mayUse;
    QStringList qtModules;
};

QString sourceOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QStringList wordsOf(const QString& cell)
{
    static const QRegularExpression separator(QStringLiteral("[, ]+"));
    return cell.split(separator, Qt::SkipEmptyParts);
}

/// Rows `| name | may use | Qt | duty |` after the heading row; "all above" is spelled out.
QList<Layer> parseTable(const QString& markdown)
{
    QList<Layer> layers;
    bool inTable = false;
    for (const QString& line : markdown.split(QLatin1Char('\n'))) {
        const QStringList cells = line.split(QLatin1Char('|'));
        if (cells.size() < 6 || !line.startsWith(QLatin1Char('|'))) {
            inTable = false;
        } else if (cells[1].trimmed() == QLatin1String("layer")) {
            inTable = true;
        } else if (inTable && !cells[1].contains(QLatin1String("---"))) {
            Layer layer{cells[1].trimmed(), wordsOf(cells[2]), wordsOf(cells[3])};
            if (cells[2].trimmed() == QLatin1String("all above")) {
                layer.mayUse.clear();
                for (const Layer& above : layers)
                    layer.mayUse.append(above.name);
            }
            layer.mayUse.removeAll(QStringLiteral("–"));
            layers.append(layer);
        }
    }
    return layers;
}

/// Rows `| folder, folder | may use |` of the table of ui's folders; "all" is every folder named.
QMap<QString, QStringList> parseUiFolders(const QString& markdown)
{
    QMap<QString, QStringList> folders;
    bool inTable = false;
    for (const QString& line : markdown.split(QLatin1Char('\n'))) {
        const QStringList cells = line.split(QLatin1Char('|'));
        if (cells.size() != 4) {
            inTable = false;
        } else if (cells[1].trimmed() == QLatin1String("ui folder")) {
            inTable = true;
        } else if (inTable && !cells[1].contains(QLatin1String("---"))) {
            for (const QString& folder : wordsOf(cells[1]))
                folders.insert(folder, wordsOf(cells[2]));
        }
    }
    for (QStringList& used : folders) {
        if (used == QStringList(QStringLiteral("all")))
            used = folders.keys();
    }
    return folders;
}

/// The folders of ui that a source includes.
QStringList uiFoldersIn(const QString& source)
{
    static const QRegularExpression line(QStringLiteral("^#include \"ui/([a-z]+)/"),
                                         QRegularExpression::MultilineOption);
    QStringList folders;
    for (auto it = line.globalMatch(source); it.hasNext();)
        folders.append(it.next().captured(1));
    return folders;
}

const Layer* find(const QList<Layer>& layers, const QString& name)
{
    for (const Layer& layer : layers) {
        if (layer.name == name)
            return &layer;
    }
    return nullptr;
}

/// What is wrong with the `#include "…"` lines of a source; `exists` answers for "layer/file.h".
QStringList wrongIncludes(const QString& source, const Layer& own, const QList<Layer>& layers,
                          const std::function<bool(const QString&)>& exists)
{
    static const QRegularExpression line(
        QStringLiteral("^\\s*#\\s*include\\s*(?:\"([^\"]*)\"|<([a-z]+/[^>]*)>)"),
        QRegularExpression::MultilineOption);
    // "layer/file.h" or, where a layer has folders, "layer/folder/file.h".
    static const QRegularExpression shape(QStringLiteral("^([a-z]+)(?:/[a-z]+)?/[a-z0-9_]+\\.h$"));
    QStringList wrong;
    for (auto it = line.globalMatch(source); it.hasNext();) {
        const auto match = it.next();
        const bool quotes = match.hasCaptured(1) && !match.captured(1).isNull();
        const QString path = quotes ? match.captured(1) : match.captured(2);
        const auto parts = shape.match(path);
        const bool named = find(layers, path.section(QLatin1Char('/'), 0, 0)) != nullptr;
        if (!quotes && !named)
            continue; // a system header: <sys/file.h>, <tl/expected.hpp>
        if (quotes && path.endsWith(QLatin1String(".moc")))
            continue;
        const QString layer = parts.captured(1);
        if (!quotes || !parts.hasMatch() || !named || !exists(path))
            wrong.append(path + QStringLiteral(": write \"layer/file.h\""));
        else if (layer != own.name && !own.mayUse.contains(layer))
            wrong.append(path + QStringLiteral(": not for ") + own.name);
    }
    return wrong;
}

/// The Qt modules ("Core", "Network") that have this header.
QStringList modulesOf(const QString& header)
{
    static const QDir headers(QLibraryInfo::path(QLibraryInfo::HeadersPath));
    static const QStringList folders = headers.entryList({QStringLiteral("Qt*")}, QDir::Dirs);
    QStringList modules;
    for (const QString& folder : folders) {
        if (headers.exists(folder + QLatin1Char('/') + header))
            modules.append(folder.mid(2));
    }
    return modules;
}

QStringList qtHeadersIn(const QString& source)
{
    static const QRegularExpression line(
        QStringLiteral("^\\s*#\\s*include\\s*<(?:Qt\\w+/)?(Q[A-Za-z0-9]+)>"),
        QRegularExpression::MultilineOption);
    QStringList headers;
    for (auto it = line.globalMatch(source); it.hasNext();)
        headers.append(it.next().captured(1));
    return headers;
}

/// Names of sources in comments, or in all of a document: "file.h", "folder/file.cpp".
QStringList filesMentionedIn(const QString& text, bool inComments)
{
    static const QRegularExpression comment(QStringLiteral("//[^\n]*"));
    static const QRegularExpression name(
        QStringLiteral("(?<![\\w/<\".])(?:[a-z_0-9]+/)*[a-z0-9_]+\\.(?:h|cpp)\\b"));
    QString searched = text;
    if (inComments) {
        searched.clear();
        for (auto it = comment.globalMatch(text); it.hasNext();)
            searched += it.next().captured() + u'\n';
    }
    QStringList files;
    for (auto it = name.globalMatch(searched); it.hasNext();)
        files.append(it.next().captured());
    return files;
}

struct Linked {
    QStringList layers;
    QStringList qtModules;
};

/// `servodesk_layer(NAME DEPENDS … QT …)` of src/CMakeLists.txt.
QMap<QString, Linked> parseCMake(const QString& text)
{
    static const QRegularExpression call(
        QStringLiteral("^servodesk_layer\\((\\w+)(?:\\s+DEPENDS ([^)]*?))?(?:\\s+QT ([^)]*))?\\)"),
        QRegularExpression::MultilineOption);
    static const QRegularExpression space(QStringLiteral("\\s+"));
    QMap<QString, Linked> found;
    for (auto it = call.globalMatch(text); it.hasNext();) {
        const auto match = it.next();
        found.insert(match.captured(1), {match.captured(2).split(space, Qt::SkipEmptyParts),
                                         match.captured(3).split(space, Qt::SkipEmptyParts)});
    }
    return found;
}
} // namespace

class TestLayering : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        m_layers = parseTable(sourceOf(m_root + QStringLiteral("/CONTRIBUTING.md")));
        QVERIFY(m_layers.size() >= 12);
    }

    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void layersOnlyUseLayersAbove()
    {
        QStringList above;
        for (const Layer& layer : m_layers) {
            for (const QString& used : layer.mayUse)
                QVERIFY2(above.contains(used), qPrintable(layer.name + u' ' + used));
            above.append(layer.name);
        }
    }

    void everyFolderIsALayer()
    {
        const QDir src(m_root + QStringLiteral("/src"));
        for (const QString& folder : src.entryList(QDir::Dirs | QDir::NoDotAndDotDot))
            QVERIFY2(find(m_layers, folder), qPrintable(folder));
    }

    void includesFollowTheTable_data()
    {
        QTest::addColumn<QString>("layerName");
        QTest::addColumn<QString>("folder");
        for (const Layer& layer : m_layers) {
            for (const char* top : {"/src/", "/"}) {
                const QString folder = m_root + QLatin1String(top) + layer.name;
                if (QDir(folder).exists())
                    QTest::newRow(qPrintable(layer.name)) << layer.name << folder;
            }
        }
    }
    void includesFollowTheTable()
    {
        QFETCH(const QString, layerName);
        QFETCH(const QString, folder);
        const Layer& layer = *find(m_layers, layerName);
        const auto exists = [this](const QString& path) {
            return QFile::exists(m_root + QStringLiteral("/src/") + path) ||
                   QFile::exists(m_root + u'/' + path);
        };
        QDirIterator files(folder, {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                           QDirIterator::Subdirectories);
        QStringList wrong;
        QVERIFY(files.hasNext());
        while (files.hasNext()) {
            const QString file = files.next();
            const QString source = sourceOf(file);
            for (const QString& what : wrongIncludes(source, layer, m_layers, exists))
                wrong.append(file + QStringLiteral(" includes ") + what);
            for (const QString& header : qtHeadersIn(source)) {
                const QStringList modules = modulesOf(header);
                const bool allowed =
                    std::any_of(modules.begin(), modules.end(), [&](const QString& module) {
                        return layer.qtModules.contains(module);
                    });
                if (!allowed)
                    wrong.append(QStringLiteral("%1 includes <%2> of Qt %3")
                                     .arg(file, header, modules.join(u'/')));
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    }

    void uiFoldersFollowTheirTable()
    {
        const auto table = parseUiFolders(sourceOf(m_root + QStringLiteral("/CONTRIBUTING.md")));
        const QDir ui(m_root + QStringLiteral("/ui"));
        const QStringList folders = ui.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
        QVERIFY(folders.size() > 10);
        QStringList wrong;
        for (const QString& folder : folders) {
            QVERIFY2(table.contains(folder), qPrintable(folder));
            QDirIterator files(ui.filePath(folder), QDir::Files);
            while (files.hasNext()) {
                const QString file = files.next();
                for (const QString& used : uiFoldersIn(sourceOf(file))) {
                    if (used != folder && !table[folder].contains(used))
                        wrong.append(file + QStringLiteral(" includes ui/") + used);
                }
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    }

    void everySourceIsListed()
    {
        QStringList missing;
        for (const char* top : {"src", "ui"}) {
            const QDir root(m_root + u'/' + QLatin1String(top));
            QDirIterator files(root.path(), {QStringLiteral("*.h"), QStringLiteral("*.cpp")},
                               QDir::Files, QDirIterator::Subdirectories);
            while (files.hasNext()) {
                const QString path = root.relativeFilePath(files.next());
                const QString layer = QLatin1String(top) == QLatin1String("src")
                                          ? path.section(u'/', 0, 0)
                                          : QStringLiteral(".");
                const QString listed = layer == u'.' ? path : path.section(u'/', 1);
                const QString lists =
                    sourceOf(QDir(root.filePath(layer)).filePath(QStringLiteral("CMakeLists.txt")));
                // The mains of the command line: main_${name}.cpp.
                const bool isMain = path.contains(QLatin1String("cli/main_"));
                const QRegularExpression line(
                    QStringLiteral("[\\s(]%1[\\s)]").arg(QRegularExpression::escape(listed)));
                if (!isMain && !line.match(lists).hasMatch())
                    missing.append(path);
            }
        }
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join(u'\n')));
    }

    void buildLinksMatchTheTable()
    {
        const QString text = sourceOf(m_root + QStringLiteral("/src/CMakeLists.txt"));
        const QMap<QString, Linked> linked = parseCMake(text);
        QVERIFY(linked.size() >= 11);
        for (auto it = linked.begin(); it != linked.end(); ++it) {
            const Layer* layer = find(m_layers, it.key());
            QVERIFY2(layer, qPrintable(it.key()));
            QStringList built;
            for (const QString& used : layer->mayUse) {
                if (linked.contains(used))
                    built.append(used);
            }
            QCOMPARE(QSet<QString>(it->layers.begin(), it->layers.end()),
                     QSet<QString>(built.begin(), built.end()));
            for (const QString& module : it->qtModules)
                QVERIFY2(layer->qtModules.contains(module), qPrintable(it.key() + module));
        }
        QDirIterator files(m_root + QStringLiteral("/src"), {QStringLiteral("CMakeLists.txt")},
                           QDir::Files, QDirIterator::Subdirectories);
        while (files.hasNext())
            QVERIFY(!sourceOf(files.next()).contains(QLatin1String("Widgets")));
    }

    // The test of the test: each kind of trespass is noticed.
    void violationsAreDetected_data()
    {
        QTest::addColumn<QString>("source");
        QTest::addColumn<int>("complaints");
        QTest::newRow("allowed") << QStringLiteral("#include \"base/error.h\"\n") << 0;
        QTest::newRow("its own") << QStringLiteral("#include \"protocol/codec.h\"") << 0;
        QTest::newRow("system") << QStringLiteral("#include <sys/file.h>\n#include <vector>") << 0;
        QTest::newRow("forbidden") << QStringLiteral("#include \"bus/bus.h\"") << 1;
        QTest::newRow("in brackets") << QStringLiteral("#include <bus/bus.h>") << 1;
        QTest::newRow("no layer") << QStringLiteral("#include \"error.h\"") << 1;
        QTest::newRow("relative") << QStringLiteral("#include \"../base/error.h\"") << 1;
        QTest::newRow("indented") << QStringLiteral("\n  #  include \"bus/bus.h\"") << 1;
        QTest::newRow("a room of the window") << QStringLiteral("#include \"ui/app/theme.h\"") << 1;
        QTest::newRow("missing") << QStringLiteral("#include \"base/nothing.h\"") << 1;
    }
    void violationsAreDetected()
    {
        QFETCH(const QString, source);
        QFETCH(const int, complaints);
        const auto exists = [](const QString& path) { return !path.contains(u"nothing"); };
        const Layer& protocol = *find(m_layers, QStringLiteral("protocol"));
        QCOMPARE(wrongIncludes(source, protocol, m_layers, exists).size(), complaints);
    }

    /// A consent is made where it was asked for, and nowhere else.
    void consentIsMadeWhereItIsAskedFor()
    {
        const QHash<QString, QStringList> places{
            {QStringLiteral("Consent::confirmed("),
             {QStringLiteral("ui/app/undo_redo.cpp"),
              QStringLiteral("ui/commissioning/commission_form.cpp"),
              QStringLiteral("ui/history/history_undo.cpp"),
              QStringLiteral("ui/memory/memory_page.cpp"),
              QStringLiteral("ui/snapshots/apply_dialog.cpp"),
              QStringLiteral("ui/snapshots/restore_panel.cpp"),
              QStringLiteral("ui/tasks/task_dialog.cpp")}},
            {QStringLiteral("Consent::byOption("),
             {QStringLiteral("src/cli/commands/cmd_commission.cpp"),
              QStringLiteral("src/cli/commands/cmd_write.cpp"),
              QStringLiteral("src/cli/output/restore_text.cpp")}},
            {QStringLiteral("Consent::ofEarlierChange("),
             {QStringLiteral("src/jobs/recover/recover_apply.cpp"),
              QStringLiteral("src/jobs/restore/restore_run.cpp")}},
            {QStringLiteral("Consent::byTask("),
             {QStringLiteral("src/jobs/arm/joint_access.cpp"),
              QStringLiteral("src/device/motion/mode_switch.cpp"),
              QStringLiteral("src/jobs/change/clear_alarm.cpp"),
              QStringLiteral("src/jobs/temporary_settings.cpp")}}};
        int found = 0;
        for (const char* top : {"src", "ui"}) {
            QDirIterator files(m_root + u'/' + QLatin1String(top), {QStringLiteral("*.cpp")},
                               QDir::Files, QDirIterator::Subdirectories);
            while (files.hasNext()) {
                const QString path = files.next();
                const QString relative = QDir(m_root).relativeFilePath(path);
                const QString source = sourceOf(path);
                for (auto place = places.begin(); place != places.end(); ++place) {
                    if (!source.contains(place.key()))
                        continue;
                    ++found;
                    QVERIFY2(place->contains(relative), qPrintable(relative + u' ' + place.key()));
                }
            }
        }
        QCOMPARE(found, 16); // no place of the list has gone
    }

    /// "file.h" may be in any folder; a path must be right from its first folder on.
    void filesMentionedExist()
    {
        QStringList paths;
        for (const char* top : {"src", "ui", "tests"}) {
            QDirIterator files(m_root + u'/' + QLatin1String(top),
                               {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                               QDirIterator::Subdirectories);
            while (files.hasNext())
                paths.append(files.next());
        }
        const QStringList documents{m_root + QStringLiteral("/CONTRIBUTING.md"),
                                    m_root + QStringLiteral("/README.md")};
        QStringList gone;
        int found = 0;
        for (const QString& file : paths + documents) {
            const bool isSource = !documents.contains(file);
            for (const QString& name : filesMentionedIn(sourceOf(file), isSource)) {
                ++found;
                const QString end = u'/' + name;
                if (std::none_of(paths.begin(), paths.end(),
                                 [&](const QString& path) { return path.endsWith(end); }))
                    gone.append(QStringLiteral("%1 mentions %2").arg(file, name));
            }
        }
        QVERIFY2(gone.isEmpty(), qPrintable(gone.join(u'\n')));
        QVERIFY(found > 50);
    }

    void mentionsAreFound()
    {
        const QString one = QStringLiteral("c/d") + QStringLiteral(".cpp");
        const QString other = QStringLiteral("j") + QStringLiteral(".h");
        const QString source =
            QStringLiteral("#include \"a/b.h\" // see %1, <e/f.h>\ng(\"i.h\"); // %2")
                .arg(one, other);
        QCOMPARE(filesMentionedIn(source, true), QStringList({one, other}));
    }

    void qtModulesAreChecked()
    {
        QCOMPARE(modulesOf(QStringLiteral("QString")), QStringList(QStringLiteral("Core")));
        QCOMPARE(modulesOf(QStringLiteral("QWidget")), QStringList(QStringLiteral("Widgets")));
        QCOMPARE(qtHeadersIn(QStringLiteral("#include <QtWidgets/QLabel>\n#include <QDir>")),
                 QStringList({QStringLiteral("QLabel"), QStringLiteral("QDir")}));
    }

private:
    const QString m_root = QStringLiteral(SOURCE_DIR);
    QList<Layer> m_layers;
};

SERVODESK_GUILESS_TEST(TestLayering)
#include "tst_layering.moc"
