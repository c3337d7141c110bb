// SPDX-License-Identifier: GPL-3.0-or-later
// The keyboard of the plot: everything the mouse can do.
#include "ui/charts/trend_plot.h"

#include <QKeyEvent>

namespace ui {
namespace {
constexpr double smallPan = 0.1;
constexpr double closer = 0.8;
constexpr double farNudge = 10; ///< pixels
constexpr int manySamples = 10;
} // namespace

void TrendPlot::keyPressEvent(QKeyEvent* event)
{
    const Qt::KeyboardModifiers with = event->modifiers() & ~Qt::KeypadModifier;
    m_scene->overlay().setFocused(true);
    if (cursorKey(event->key(), event->text(), with) || moveKey(event->key(), with) ||
        zoomKey(event->key(), with) ||
        ((with & ~Qt::ShiftModifier) == Qt::NoModifier && plainKey(event->key())))
        event->accept();
    else
        event->ignore(); // the window's shortcuts and Esc
}

/// [ and ] move A, with Shift B; Alt and the arrows do the same on keyboards without brackets.
bool TrendPlot::cursorKey(int key, const QString& text, Qt::KeyboardModifiers with)
{
    const bool shift = with.testFlag(Qt::ShiftModifier);
    const bool far = with.testFlag(Qt::ControlModifier);
    double step = 0;
    Cursor which = shift ? Cursor::B : Cursor::A;
    if (key == Qt::Key_BracketLeft || key == Qt::Key_BraceLeft)
        step = -1;
    else if (key == Qt::Key_BracketRight || key == Qt::Key_BraceRight)
        step = 1;
    else if (with.testFlag(Qt::AltModifier) && (key == Qt::Key_Left || key == Qt::Key_Right))
        step = key == Qt::Key_Left ? -1 : 1;
    if (step == 0)
        return false;
    if (text == QLatin1String("{") || text == QLatin1String("}"))
        which = Cursor::B;
    Q_EMIT cursorNudged(which, step * (far ? farNudge : 1));
    return true;
}

bool TrendPlot::moveKey(int key, Qt::KeyboardModifiers with)
{
    if (with.testFlag(Qt::AltModifier) || with.testFlag(Qt::ControlModifier))
        return false;
    const bool shift = with.testFlag(Qt::ShiftModifier);
    if (m_scene->hasCursors() && (key == Qt::Key_Left || key == Qt::Key_Right)) {
        Q_EMIT cursorStepped((key == Qt::Key_Left ? -1 : 1) * (shift ? manySamples : 1));
        return true;
    }
    const double by = shift ? 5 * smallPan : smallPan;
    switch (key) {
    case Qt::Key_Left:
        Q_EMIT panned(by, 0);
        break;
    case Qt::Key_Right:
        Q_EMIT panned(-by, 0);
        break;
    case Qt::Key_Up:
        Q_EMIT panned(0, -by);
        break;
    case Qt::Key_Down:
        Q_EMIT panned(0, by);
        break;
    case Qt::Key_PageUp:
        Q_EMIT panned(1, 0);
        break;
    case Qt::Key_PageDown:
        Q_EMIT panned(-1, 0);
        break;
    default:
        return false;
    }
    Q_EMIT panEnded();
    return true;
}

/// With Shift the values; + and = share a key on many keyboards, so both count.
bool TrendPlot::zoomKey(int key, Qt::KeyboardModifiers with)
{
    if (with.testFlag(Qt::AltModifier) || with.testFlag(Qt::ControlModifier))
        return false;
    switch (key) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        Q_EMIT zoomed(closer, 0.5);
        return true;
    case Qt::Key_Minus:
        Q_EMIT zoomed(1 / closer, 0.5);
        return true;
    case Qt::Key_Asterisk:
    case Qt::Key_Y:
        Q_EMIT valuesZoomed(nullptr, with.testFlag(Qt::ShiftModifier) ? 1 / closer : closer, 0.5);
        return true;
    default:
        return false;
    }
}

bool TrendPlot::plainKey(int key)
{
    switch (key) {
    case Qt::Key_Home:
        Q_EMIT endRequested(false);
        return true;
    case Qt::Key_End:
        Q_EMIT endRequested(true);
        return true;
    case Qt::Key_Space:
        Q_EMIT pauseRequested();
        return true;
    case Qt::Key_Backspace:
        Q_EMIT backRequested();
        return true;
    case Qt::Key_F:
        Q_EMIT fitRequested();
        return true;
    case Qt::Key_C:
        Q_EMIT cursorsRequested();
        return true;
    default:
        break;
    }
    if (key < Qt::Key_1 || key > Qt::Key_9)
        return false;
    Q_EMIT channelToggleRequested(key - Qt::Key_1);
    return true;
}
} // namespace ui
