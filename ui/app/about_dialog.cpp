// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/about_dialog.h"

#include "session/paths.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QLabel>
#include <QVBoxLayout>

namespace ui {
AboutDialog::AboutDialog(QWidget* parent)
    : QDialog(parent)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName(QStringLiteral("about"));
    setWindowTitle(tr("About ServoDesk"));
    auto* text = new QLabel(this);
    text->setTextFormat(Qt::RichText);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text->setWordWrap(true);
    text->setMinimumWidth(460);
    const QStringList paragraphs{
        QStringLiteral("<h2>ServoDesk %1</h2>").arg(QCoreApplication::applicationVersion()),
        tr("Setup and test program for serial bus servos: Feetech SCS, STS, SMS and HLS, SMS over "
           "Modbus-RTU, and Hiwonder LX."),
        tr("Free software under the GNU General Public License, version 3 or later, without any "
           "warranty. Icons: Breeze, by the KDE Visual Design Group, LGPL 3 or later. Built with "
           "Qt %1.")
            .arg(QLatin1String(qVersion())),
        tr("Journal and snapshots: %1")
            .arg(QDir::toNativeSeparators(session::dataFolder()).toHtmlEscaped()),
        tr("Your own servo models (JSON files): %1")
            .arg(QDir::toNativeSeparators(session::modelFolder()).toHtmlEscaped()),
    };
    text->setText(QStringLiteral("<p>%1</p>").arg(paragraphs.join(QStringLiteral("</p><p>"))));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(text, 1);
    column->addWidget(buttons);
}
} // namespace ui
