// SPDX-License-Identifier: GPL-3.0-or-later
// What jobs that may hang leave of their thread: nothing where it ended in time, and no crash at
// the end of the program where it did not.
#include "session/detachable_worker.h"
#include "support/test_main.h"

#include <QProcess>
#include <QtTest>

#include <atomic>
#include <cstdlib>
#include <future>

using namespace std::chrono_literals;
using session::DetachableWorker;

namespace {
constexpr int timeoutMs = 60'000; ///< only a hung program ever needs it
const QString detachedThreadMode = QStringLiteral("leaves-a-thread-behind");
constexpr int expectedExitCode = 7;
constexpr int tornDownExitCode = 99;

std::atomic<bool> isCleanedUp;

/// Such as the libraries of a history server keep for each thread, slow to clean up.
struct SlowThreadLocal {
    bool used = false;
    ~SlowThreadLocal()
    {
        std::this_thread::sleep_for(50ms);
        isCleanedUp = used;
    }
};
thread_local SlowThreadLocal slowThreadLocal;

/// A job that hangs until the test is over, with its thread left behind.
int leaveDetachedThread()
{
    std::atexit([] { std::_Exit(tornDownExitCode); });
    const auto begun = std::make_shared<std::promise<void>>();
    DetachableWorker thread;
    thread.start([begun] {
        begun->set_value();
        for (;;)
            std::this_thread::sleep_for(1h);
    });
    begun->get_future().wait();
    return thread.finish(1ms) ? tornDownExitCode : expectedExitCode;
}
} // namespace

class TestDetachableWorker : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void finishedThreadsAreJoined();
    void anIdleThreadIsNotDetached();
    void detachedThreadsSkipStaticDestruction();
};

void TestDetachableWorker::finishedThreadsAreJoined()
{
    isCleanedUp = false;
    std::promise<void> done;
    DetachableWorker thread;
    thread.start([&] {
        slowThreadLocal.used = true;
        done.set_value();
    });
    done.get_future().wait();
    QVERIFY(thread.finish(std::chrono::milliseconds(timeoutMs)));
    QVERIFY(isCleanedUp);
    QVERIFY(thread.finish({})); // and stays so
}

void TestDetachableWorker::anIdleThreadIsNotDetached()
{
    DetachableWorker thread;
    QVERIFY(thread.finish({}));
}

void TestDetachableWorker::detachedThreadsSkipStaticDestruction()
{
    QProcess program;
    program.start(QCoreApplication::applicationFilePath(),
                  {QStringLiteral("tst_detachable_worker"), detachedThreadMode});
    QVERIFY(program.waitForFinished(timeoutMs));
    QCOMPARE(program.exitStatus(), QProcess::NormalExit);
    QCOMPARE(program.exitCode(), expectedExitCode);
}

static int runTestDetachableWorker(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    if (QCoreApplication::arguments().mid(1) == QStringList(detachedThreadMode))
        return DetachableWorker::exitCode(leaveDetachedThread());
    TestDetachableWorker test;
    return QTest::qExec(&test, argc, argv);
}
SERVODESK_TEST_RUN(runTestDetachableWorker)
#include "tst_detachable_worker.moc"
