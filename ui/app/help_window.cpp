// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/help_window.h"

#include "report/fonts.h"
#include "text/language.h"
#include "ui/common/dialog_sizes.h"
#include "ui/common/theme.h"

#include <QEvent>
#include <QFile>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QVBoxLayout>

#include <vector>

namespace ui {
namespace {
constexpr int margin = 16; ///< text at the very edge is hard to read

/// Pictures are named IMAGE:page in the text; there is one for each language and theme.
QString withImages(QString markdown, bool chinese, bool dark)
{
    const QString ending = QStringLiteral("-%1-%2.png)")
                               .arg(chinese ? QStringLiteral("zh") : QStringLiteral("en"),
                                    dark ? QStringLiteral("dark") : QStringLiteral("light"));
    for (const char* page :
         {"memory", "search", "operate", "sweep", "step", "snapshots", "history"}) {
        const QString name = QString::fromLatin1(page);
        markdown.replace(QStringLiteral("(IMAGE:%1)").arg(name),
                         QStringLiteral("(qrc:/help/images/") + name + ending);
    }
    return markdown;
}

/// Code in the program's own font; Markdown would use that of the desktop.
void useCodeFont(QTextDocument& document)
{
    QTextCharFormat code;
    code.setFontFamilies(report::codeFamilies());
    std::vector<std::pair<int, int>> pieces;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        for (auto it = block.begin(); !it.atEnd(); ++it) {
            const QTextFragment piece = it.fragment();
            if (piece.charFormat().fontFixedPitch())
                pieces.emplace_back(piece.position(), piece.position() + piece.length());
        }
    }
    QTextCursor cursor(&document);
    for (const auto& [begin, end] : pieces) {
        cursor.setPosition(begin);
        cursor.setPosition(end, QTextCursor::KeepAnchor);
        cursor.mergeCharFormat(code);
    }
}
} // namespace

HelpWindow::HelpWindow(QWidget* parent)
    : QDialog(parent)
    , m_text(new QTextBrowser(this))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName(QStringLiteral("help"));
    rememberSize(*this);
    m_text->setObjectName(QStringLiteral("helpText"));
    m_text->document()->setDocumentMargin(margin);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_text);
    resize(900, 700);
    fill();
}

void HelpWindow::fill()
{
    setWindowTitle(tr("ServoDesk Help"));
    m_text->setAccessibleName(tr("Help"));
    m_text->setToolTip(tr("Help"));
    const bool chinese = text::isUiChinese();
    QFile file(chinese ? QStringLiteral(":/help/help_zh.md") : QStringLiteral(":/help/help_en.md"));
    if (!file.open(QIODevice::ReadOnly))
        return;
    m_text->setMarkdown(withImages(QString::fromUtf8(file.readAll()), chinese, isDark(palette())));
    if (!report::codeFamilies().isEmpty())
        useCodeFont(*m_text->document());
}

void HelpWindow::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        fill();
}
} // namespace ui
