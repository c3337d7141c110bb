// SPDX-License-Identifier: GPL-3.0-or-later
// What jobs that may hang leave of their thread: nothing where it ended in time, and no crash at
// the end of the program where it did not.
#include "session/loose_thread.h"

#include <QProcess>
#include <QtTest>

#include <atomic>
#include <cstdlib>
#include <future>

using namespace std::chrono_literals;
using session::LooseThread;

namespace {
constexpr int patienceMs = 60'000; ///< only a hung program ever needs it
const QString leaves = QStringLiteral("leaves-a-thread-behind");
constexpr int codeOfProgram = 7;
constexpr int tornDown = 99;

std::atomic<bool> cleanedUp;

/// Such as the libraries of a history server keep for each thread, slow to clean up.
struct OfThread {
    bool used = false;
    ~OfThread()
    {
        std::this_thread::sleep_for(50ms);
        cleanedUp = used;
    }
};
thread_local OfThread ofThread;

/// A job that hangs until the test is over, with its thread left behind.
int leaveAThread()
{
    std::atexit([] { std::_Exit(tornDown); });
    const auto begun = std::make_shared<std::promise<void>>();
    LooseThread thread;
    thread.start([begun] {
        begun->set_value();
        for (;;)
            std::this_thread::sleep_for(1h);
    });
    begun->get_future().wait();
    return thread.end(1ms) ? tornDown : codeOfProgram;
}
} // namespace

class TestLooseThread : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatEndsInTimeHasEndedAltogether();
    void anIdleOneIsNotLeftBehind();
    void whatIsLeftBehindDoesNotSeeTheEnd();
};

void TestLooseThread::whatEndsInTimeHasEndedAltogether()
{
    cleanedUp = false;
    std::promise<void> done;
    LooseThread thread;
    thread.start([&] {
        ofThread.used = true;
        done.set_value();
    });
    done.get_future().wait();
    QVERIFY(thread.end(std::chrono::milliseconds(patienceMs)));
    QVERIFY(cleanedUp);
    QVERIFY(thread.end({})); // and stays so
}

void TestLooseThread::anIdleOneIsNotLeftBehind()
{
    LooseThread thread;
    QVERIFY(thread.end({}));
}

void TestLooseThread::whatIsLeftBehindDoesNotSeeTheEnd()
{
    QProcess program;
    program.start(QCoreApplication::applicationFilePath(), {leaves});
    QVERIFY(program.waitForFinished(patienceMs));
    QCOMPARE(program.exitStatus(), QProcess::NormalExit);
    QCOMPARE(program.exitCode(), codeOfProgram);
}

int main(int argc, char* argv[])
{
    QCoreApplication application(argc, argv);
    if (QCoreApplication::arguments().mid(1) == QStringList(leaves))
        return LooseThread::exitCode(leaveAThread());
    TestLooseThread test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_loose_thread.moc"
