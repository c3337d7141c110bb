// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/examples.h"

namespace cli {
const std::vector<Examples>& allExamples()
{
    static const std::vector<Examples> examples{
        {"ports", "ports", "ports --json"},
        {"find", "find", "find --json"},
        {"scan", "scan", "scan --ids 1-6 --bauds all"},
        {"diagnose", "diagnose", "diagnose --json"},
        {"info", "info 1", "info 1 --json"},
        {"dump", "dump 1", "dump 1 --json"},
        {"read", "read 1 present_position present_voltage", "read 1 position_p --json"},
        {"firmware list", "firmware list", "firmware list --json"},

        {"write", "write 1 position_p=24 position_d=20", "write 1 torque_limit=50% --temporary"},
        {"set-id", "set-id 1 11", "set-id 2 12 --json"},
        {"set-baud", "set-baud 1 500000", "--baud 1000000 set-baud 2 115200"},
        {"center", "center 1", "center 1 --json"},
        {"restore-defaults", "restore-defaults 1", "restore-defaults 1 --json"},
        {"reboot", "reboot 1", "reboot 1 --json"},
        {"clear-alarm", "clear-alarm 1", "clear-alarm 1 --move"},
        {"firmware update", "firmware update SCServo21-GD32-TTL-250306.bin 1",
         "firmware update SCServo21-GD32-TTL-250306.bin 1 2 --accept other-servos"},
        {"firmware rescue", "firmware rescue SCServo21-GD32-TTL-250306.bin",
         "firmware rescue SCServo21-GD32-TTL-250306.bin --json"},
        {"commission", "commission --batch arm.csv --first-id 11 --count 1 --auto",
         "commission --batch arm.csv --first-id 11 --count 2 --auto --to-baud 500000"},
        {"commission-report", "commission-report arm.csv arm.pdf",
         "commission-report arm.csv arm.html"},
        {"recover", "recover", "recover --finish"},

        {"torque", "torque 1 2 on", "torque 1-6 off"},
        {"stop", "stop 1", "stop 1-3"},
        {"mode", "mode 1 speed", "mode 1 position"},
        {"move", "move 1=2048 2=90deg --wait", "move 1=1000 --speed 30rpm --wait"},
        {"watch", "watch 1 2 --duration 2", "watch 1 --rate 100 --duration 2 --csv run.csv"},
        {"identify", "identify 1", "identify 1 --json"},

        {"sweep", "sweep 1 --from 1000 --to 3000 --delay 1500 --cycles 1",
         "sweep 1 2 --from 90deg --to 150deg --dwell 300 --cycles 2 --report sweep.html"},
        {"sweep-runs", "sweep-runs", "sweep-runs --model STS3215"},
        {"sweep-report", "sweep-report 1 sweep.pdf", "sweep-report 2 sweep.csv"},
        {"sweep-reference", "sweep-reference 1", "sweep-reference 2:1"},
        {"sweep-compare", "sweep-compare 1 2:1", "sweep-compare 1 2:1 --report compared.html"},
        {"step-response", "step-response 1 --size 30deg --repeats 1",
         "step-response 1 --size 30deg --repeats 1 --try position_p=40"},
        {"step-runs", "step-runs", "step-runs --model STS3215"},
        {"step-report", "step-report 3 step.html", "step-report 3 step.pdf"},
        {"step-compare", "step-compare 3 4", "step-compare 3 4 --report gains.html"},

        {"snapshot save", "snapshot save 1 knee.servo.json",
         "snapshot save 2 hip.servo.json --label \"left hip\""},
        {"snapshot show", "snapshot show knee.servo.json",
         "snapshot show knee.servo.json --report knee.pdf"},
        {"snapshot diff", "snapshot diff 1 knee.servo.json",
         "snapshot diff knee.servo.json hip.servo.json default"},
        {"snapshot restore", "snapshot restore 1 knee.servo.json --dry-run",
         "snapshot restore 1 knee.servo.json"},
        {"bundle save", "bundle save arm.bundle.json", "bundle save legs.bundle.json 1-3"},
        {"bundle restore", "bundle restore arm.bundle.json --dry-run",
         "bundle restore arm.bundle.json"},
        {"template make", "template make 1 gains.servo.json position_p position_d",
         "template make knee.servo.json limits.servo.json max_temperature protection_time"},
        {"template apply", "template apply gains.servo.json 1-3 --dry-run",
         "template apply gains.servo.json 1-3"},

        {"arm show", "arm show", "arm show --json"},
        {"arm calibrate", "arm calibrate --joint gripper --seconds 4 --yes --dry-run",
         "arm calibrate --joint gripper --seconds 4 --yes"},
        {"arm export", "arm export so101.json", "arm export my-arm.json --format arm"},
        {"arm compare", "arm compare so101.json", "arm compare so101.json --json"},
        {"arm apply", "arm apply so101.json --dry-run", "arm apply so101.json --yes"},
        {"arm prepare", "arm prepare --dry-run", "arm prepare --yes"},
        {"arm test", "arm test --joint wrist_roll --yes",
         "arm test --joint wrist_roll --torque 50 --yes"},

        {"history label", "history label 1 knee", "history label 2 \"left hip\""},
        {"history show", "history show 1", "history show 1 --json"},
        {"history snapshot", "history snapshot 1 first.servo.json",
         "history snapshot 1 first.servo.json --json"},
        {"history table", "history table knee 2h then.servo.json",
         "history table 1 90m then.servo.json"},
        {"history sync", "history sync --server postgresql://user@host/servodesk --remember",
         "history sync"},
        {"history", "history --since 2d --servo knee", "history --kind alarms --csv alarms.csv"},

        {"raw", "raw FF FF 01 02 01 FB", "raw FF FF 01 04 02 38 02 BE"},
        {"tour", "--port sim:demo tour", "--port sim:demo --lang zh_CN tour"},
    };
    return examples;
}
} // namespace cli
