<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Ask</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Leaves everything unchanged</source>
        <translation>保持原样，不做任何修改</translation>
    </message>
</context>
<context>
    <name>BusText</name>
    <message>
        <source>six servos, one with an alarm</source>
        <translation>六个舵机，其中一个报警</translation>
    </message>
    <message>
        <source>mixed baud rates, two servos sharing one ID, faults</source>
        <translation>多种波特率、两个舵机 ID 相同、有故障</translation>
    </message>
    <message>
        <source>one SMS servo on Modbus-RTU</source>
        <translation>一个使用 Modbus-RTU 的 SMS 舵机</translation>
    </message>
    <message>
        <source>five Hiwonder LX servos</source>
        <translation>五个幻尔 LX 舵机</translation>
    </message>
    <message>
        <source>six new servos to commission</source>
        <translation>六个待设置的新舵机</translation>
    </message>
    <message>
        <source>six servos to commission, some with faults</source>
        <translation>六个待设置的舵机，部分有故障</translation>
    </message>
    <message>
        <source>a good, a worn and a badly damped servo to test</source>
        <translation>三个待测舵机：良好、磨损、阻尼不良各一个</translation>
    </message>
    <message>
        <source>six new servos, all with ID 1</source>
        <translation>六个新舵机，ID 全为 1</translation>
    </message>
    <message>
        <source>Feetech</source>
        <translation>飞特</translation>
    </message>
    <message>
        <source>robot arm SO-101, not calibrated</source>
        <translation>机械臂 SO-101，未校准</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>&amp;Connect</source>
        <translation>连接(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>断开(&amp;D)</translation>
    </message>
    <message>
        <source>Use the &amp;simulated bus</source>
        <translation>使用模拟总线(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Search</source>
        <translation>搜索(&amp;S)</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>停止(&amp;T)</translation>
    </message>
    <message>
        <source>Stop the running &amp;task</source>
        <translation>停止当前任务(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Read all</source>
        <translation>读取全部(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Find a register</source>
        <translation>查找参数(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Copy rows</source>
        <translation>复制行(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Export the table…</source>
        <translation>导出内存表(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Print the table…</source>
        <translation>打印内存表(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Re&amp;do</source>
        <translation>重做(&amp;D)</translation>
    </message>
    <message>
        <source>Set &amp;ID…</source>
        <translation>设置 ID(&amp;I)…</translation>
    </message>
    <message>
        <source>Set &amp;baud rate…</source>
        <translation>设置波特率(&amp;B)…</translation>
    </message>
    <message>
        <source>Clear &amp;alarm…</source>
        <translation>解除报警(&amp;A)…</translation>
    </message>
    <message>
        <source>Interrupted &amp;writes…</source>
        <translation>未写完的更改(&amp;W)…</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>跟随系统(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>Dark text on a light window</source>
        <translation>浅色窗口，深色文字</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;D)</translation>
    </message>
    <message>
        <source>Light text on a dark window</source>
        <translation>深色窗口，浅色文字</translation>
    </message>
    <message>
        <source>Shows the interface in English</source>
        <translation>以英文显示界面</translation>
    </message>
    <message>
        <source>Shows the interface in Simplified Chinese</source>
        <translation>以简体中文显示界面</translation>
    </message>
    <message>
        <source>&amp;Messages</source>
        <translation>消息(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>How to connect, search, read and write</source>
        <translation>如何连接、搜索、读取和写入</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>键盘快捷键(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About ServoDesk</source>
        <translation>关于 ServoDesk(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Operate</source>
        <translation>操作(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Memory table</source>
        <translation>内存表(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Pause the chart</source>
        <translation>暂停曲线(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Record…</source>
        <translation>录制(&amp;R)…</translation>
    </message>
    <message>
        <source>Op&amp;en a recording…</source>
        <translation>打开录制文件(&amp;E)…</translation>
    </message>
    <message>
        <source>S&amp;weep test</source>
        <translation>扫描测试(&amp;W)</translation>
    </message>
    <message>
        <source>S&amp;tep response</source>
        <translation>阶跃响应(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Earlier tests…</source>
        <translation>以往测试(&amp;E)…</translation>
    </message>
    <message>
        <source>S&amp;napshots</source>
        <translation>快照(&amp;N)</translation>
    </message>
    <message>
        <source>Take s&amp;napshot</source>
        <translation>保存快照(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>历史记录(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Commissioning</source>
        <translation>批量设置(&amp;C)</translation>
    </message>
    <message>
        <source>Turns torque off, reboots the servo and waits for its reply</source>
        <translation>卸力后重启舵机并等待其应答</translation>
    </message>
    <message>
        <source>Opens the selected port and searches it for servos</source>
        <translation>打开所选端口并搜索舵机</translation>
    </message>
    <message>
        <source>Closes the port; a write in progress is completed first</source>
        <translation>关闭端口；正在进行的写入会先完成</translation>
    </message>
    <message>
        <source>Lets you try all features on simulated servos without any hardware</source>
        <translation>无需硬件，用模拟舵机试用全部功能</translation>
    </message>
    <message>
        <source>&amp;Power-cycle the simulated servos</source>
        <translation>让模拟舵机断电再上电(&amp;P)</translation>
    </message>
    <message>
        <source>Temporary values are lost, as with a real power-off</source>
        <translation>临时写入的值会丢失，与真实断电一样</translation>
    </message>
    <message>
        <source>Searches the bus for servos; writes nothing</source>
        <translation>搜索总线上的舵机；不写入任何内容</translation>
    </message>
    <message>
        <source>Ends the search; the servos found so far stay in the list</source>
        <translation>结束搜索；已找到的舵机保留在列表中</translation>
    </message>
    <message>
        <source>Ends the current task; a write in progress is completed safely first</source>
        <translation>结束当前任务；正在进行的写入会先安全完成</translation>
    </message>
    <message>
        <source>Reads the whole memory table of the selected servo; writes nothing</source>
        <translation>读取所选舵机的整个内存表；不写入任何内容</translation>
    </message>
    <message>
        <source>Moves the focus to the memory table filter</source>
        <translation>转到内存表的筛选框</translation>
    </message>
    <message>
        <source>&amp;Lock the EPROM</source>
        <translation>EPROM 上锁(&amp;L)</translation>
    </message>
    <message>
        <source>Locks the EPROM to prevent accidental permanent changes</source>
        <translation>将 EPROM 上锁，防止误改永久生效</translation>
    </message>
    <message>
        <source>Copies the selected rows of the memory table as text</source>
        <translation>以文本形式复制内存表中选中的行</translation>
    </message>
    <message>
        <source>Saves the memory table as a CSV or HTML file</source>
        <translation>把内存表保存为 CSV 或 HTML 文件</translation>
    </message>
    <message>
        <source>Prints the memory table</source>
        <translation>打印内存表</translation>
    </message>
    <message>
        <source>Writes back the values from before the last change</source>
        <translation>写回上一次更改之前的值</translation>
    </message>
    <message>
        <source>Reapplies the last undone change</source>
        <translation>重新写入被撤销的更改</translation>
    </message>
    <message>
        <source>Changes the ID of the servo after checking that the new ID is free</source>
        <translation>先确认新 ID 未被占用，再更改舵机 ID</translation>
    </message>
    <message>
        <source>Changes the servo&apos;s baud rate and continues communicating at the new rate</source>
        <translation>更改舵机波特率，并以新波特率继续通信</translation>
    </message>
    <message>
        <source>Set &amp;midpoint…</source>
        <translation>设为中位(&amp;M)…</translation>
    </message>
    <message>
        <source>Sets the present position as the midpoint</source>
        <translation>把当前位置设为中位</translation>
    </message>
    <message>
        <source>Reset to factory &amp;defaults…</source>
        <translation>恢复出厂设置(&amp;D)…</translation>
    </message>
    <message>
        <source>Resets all settings to factory defaults; saves the memory table first</source>
        <translation>先保存内存表，再将全部设置恢复为出厂值</translation>
    </message>
    <message>
        <source>&amp;Reboot…</source>
        <translation>重启舵机(&amp;R)…</translation>
    </message>
    <message>
        <source>Blin&amp;k LED</source>
        <translation>闪烁 LED(&amp;K)</translation>
    </message>
    <message>
        <source>Blinks the servo&apos;s LED for a few seconds</source>
        <translation>让舵机的 LED 闪烁几秒</translation>
    </message>
    <message>
        <source>Shows what caused the alarm and lets you clear it</source>
        <translation>显示报警原因，并可解除报警</translation>
    </message>
    <message>
        <source>Lists interrupted writes from earlier sessions</source>
        <translation>列出以前运行时未写完的更改</translation>
    </message>
    <message>
        <source>Drive and monitor the servo</source>
        <translation>驱动并监视舵机</translation>
    </message>
    <message>
        <source>View and change the stored settings of the servo</source>
        <translation>查看和修改舵机保存的参数</translation>
    </message>
    <message>
        <source>Run a sweep test and evaluate the result</source>
        <translation>运行扫描测试并评估结果</translation>
    </message>
    <message>
        <source>See how a servo responds to a step, and try other gains</source>
        <translation>查看舵机的阶跃响应，并试用其他增益</translation>
    </message>
    <message>
        <source>Save, compare and restore servo settings</source>
        <translation>保存、对比和恢复舵机的设置</translation>
    </message>
    <message>
        <source>Reads the whole memory table and saves it in the history</source>
        <translation>读取整个内存表并存入历史记录</translation>
    </message>
    <message>
        <source>Set up servos one at a time</source>
        <translation>逐个接上并设置舵机</translation>
    </message>
    <message>
        <source>All writes, snapshots, tests and alarms</source>
        <translation>所有写入、快照、测试和报警</translation>
    </message>
    <message>
        <source>Pauses or resumes the chart; measuring continues</source>
        <translation>暂停或继续更新曲线；测量不中断</translation>
    </message>
    <message>
        <source>Starts or stops recording measured values to a file</source>
        <translation>开始或停止将测量值录制到文件</translation>
    </message>
    <message>
        <source>Shows a recording in the chart</source>
        <translation>在曲线图中显示录制的数据</translation>
    </message>
    <message>
        <source>All &amp;torque off</source>
        <translation>全部卸力(&amp;T)</translation>
    </message>
    <message>
        <source>Immediately turns torque off on the whole bus (Esc, even in the input fields of the motion panel; Shift+Esc anywhere)</source>
        <translation>立即让总线上的全部舵机卸力（Esc，在运动面板的输入框中也有效；Shift+Esc 在任何界面都有效）</translation>
    </message>
    <message>
        <source>Follows the light or dark setting of the desktop</source>
        <translation>跟随桌面的浅色或深色设置</translation>
    </message>
    <message>
        <source>All messages since the program started</source>
        <translation>程序启动以来的全部消息</translation>
    </message>
    <message>
        <source>Lists all shortcuts</source>
        <translation>列出全部快捷键</translation>
    </message>
    <message>
        <source>Version, license and file locations</source>
        <translation>版本、许可证和文件存放位置</translation>
    </message>
    <message>
        <source>Quits the program; a write in progress is completed first</source>
        <translation>退出程序；正在进行的写入会先完成</translation>
    </message>
    <message>
        <source>Lists saved tests and lets you compare two or mark one as the reference</source>
        <translation>列出已保存的测试，可对比其中两次，或将其中一次设为参考</translation>
    </message>
    <message>
        <source>&amp;Why is a servo not replying?</source>
        <translation>舵机为何不应答(&amp;W)？</translation>
    </message>
    <message>
        <source>Checks the bus, tries other baud rates and protocols, and identifies the cause; writes nothing</source>
        <translation>检查总线，尝试其他波特率和协议，并指出原因；不写入任何内容</translation>
    </message>
    <message>
        <source>&amp;Find servos on all ports…</source>
        <translation>在所有端口上查找舵机(&amp;F)…</translation>
    </message>
    <message>
        <source>Searches every serial port at every baud rate; writes nothing</source>
        <translation>以所有波特率搜索每个串口；不写入任何内容</translation>
    </message>
    <message>
        <source>&amp;Firmware</source>
        <translation>固件(&amp;F)</translation>
    </message>
    <message>
        <source>Compare the firmware versions of the servos</source>
        <translation>比较各舵机的固件版本</translation>
    </message>
    <message>
        <source>&amp;Update firmware…</source>
        <translation>更新固件(&amp;U)…</translation>
    </message>
    <message>
        <source>Rescue fir&amp;mware…</source>
        <translation>救援固件(&amp;M)…</translation>
    </message>
    <message>
        <source>Writes the vendor&apos;s firmware file to the selected servo, after checks</source>
        <translation>检查后，把厂家的固件文件写入选中的舵机</translation>
    </message>
    <message>
        <source>Writes firmware to a servo that is in its bootloader</source>
        <translation>给停留在引导程序中的舵机写入固件</translation>
    </message>
    <message>
        <source>&amp;Arm</source>
        <translation>机械臂(&amp;A)</translation>
    </message>
    <message>
        <source>Calibrate a robot arm by moving its joints</source>
        <translation>通过转动关节校准机械臂</translation>
    </message>
    <message>
        <source>Use the simulated robot &amp;arm</source>
        <translation>使用模拟机械臂(&amp;A)</translation>
    </message>
    <message>
        <source>Lets you try the calibration of a robot arm without any hardware</source>
        <translation>无需硬件即可试用机械臂校准</translation>
    </message>
</context>
<context>
    <name>CommissionText</name>
    <message>
        <source>no register map for %1, so nothing is written</source>
        <translation>%1 的内存表未知，不写入</translation>
    </message>
    <message>
        <source>the servo does not support %1 baud</source>
        <translation>舵机不支持波特率 %1</translation>
    </message>
    <message>
        <source>the servo does not support ID %1</source>
        <translation>舵机不支持 ID %1</translation>
    </message>
    <message>
        <source>%1 servos have no command to set the midpoint</source>
        <translation>%1 系列没有“设为中位”指令</translation>
    </message>
    <message>
        <source>the template is for a different model: %1</source>
        <translation>模板属于其他型号：%1</translation>
    </message>
    <message>
        <source>template rows not written: %1</source>
        <translation>模板中未写入的项：%1</translation>
    </message>
    <message>
        <source>its ID is %1, not the factory default</source>
        <translation>ID 为 %1，不是出厂 ID</translation>
    </message>
    <message>
        <source>no ID is left to assign</source>
        <translation>可分配的 ID 已用完</translation>
    </message>
    <message>
        <source>it is already set up</source>
        <translation>此舵机已设置完成</translation>
    </message>
    <message>
        <source>set aside manually</source>
        <translation>手动剔除</translation>
    </message>
    <message>
        <source>its label could not be saved to the history (%1)</source>
        <translation>标签未能写入历史记录（%1）</translation>
    </message>
    <message>
        <source>%1 baud takes effect only after a reboot</source>
        <translation>波特率 %1 重启后才生效</translation>
    </message>
    <message>
        <source>its baud rate register is set to %1</source>
        <translation>波特率参数为 %1</translation>
    </message>
    <message>
        <source>torque was on; it has been turned off</source>
        <translation>扭矩原为打开状态，已卸力</translation>
    </message>
    <message>
        <source>%1 differs when read back</source>
        <translation>%1 的回读值不符</translation>
    </message>
    <message>
        <source>the write to %1 was refused</source>
        <translation>%1 的写入被拒绝</translation>
    </message>
    <message>
        <source>the write to %1 was not sent</source>
        <translation>%1 的写入指令未发送</translation>
    </message>
    <message>
        <source>no reply while writing %1</source>
        <translation>写入 %1 时无应答</translation>
    </message>
    <message>
        <source>the result of writing %1 is unknown</source>
        <translation>%1 的写入结果未知</translation>
    </message>
    <message>
        <source>the servo did not reply</source>
        <translation>舵机无应答</translation>
    </message>
    <message>
        <source>its replies could not be decoded</source>
        <translation>应答无法解析</translation>
    </message>
    <message>
        <source>the ID is already in use by another servo on the bus</source>
        <translation>ID 已被总线上的另一个舵机占用</translation>
    </message>
    <message>
        <source>two servos reply with this ID</source>
        <translation>有两个舵机以此 ID 应答</translation>
    </message>
    <message>
        <source>its family is unclear, so nothing is written</source>
        <translation>舵机系列不明，不写入</translation>
    </message>
    <message>
        <source>its firmware is unknown, so nothing is written</source>
        <translation>舵机固件未知，不写入</translation>
    </message>
    <message>
        <source>%1 does not match the template</source>
        <translation>%1 与模板的数值不一致</translation>
    </message>
    <message>
        <source>its replies did not match the requests</source>
        <translation>应答与请求不符</translation>
    </message>
    <message>
        <source>the bus was never idle</source>
        <translation>总线一直没有空闲</translation>
    </message>
    <message>
        <source>the servo did not accept the write</source>
        <translation>舵机未接受写入</translation>
    </message>
    <message>
        <source>the EPROM lock could not be confirmed</source>
        <translation>无法确认 EPROM 已上锁</translation>
    </message>
    <message>
        <source>a different servo is replying now: %1</source>
        <translation>现在应答的是另一个舵机：%1</translation>
    </message>
    <message>
        <source>the value is out of range: %1</source>
        <translation>数值超出范围：%1</translation>
    </message>
    <message>
        <source>not supported: %1</source>
        <translation>不支持：%1</translation>
    </message>
    <message>
        <source>the servo that is still unfinished has ID %1</source>
        <translation>尚未设置完的舵机 ID 为 %1</translation>
    </message>
    <message>
        <source>the servo whose setup was not finished may have one of these IDs: %1</source>
        <translation>尚未设置完的舵机可能使用以下任一 ID：%1</translation>
    </message>
    <message>
        <source>its EPROM was unlocked, and the EPROM lock could not be confirmed</source>
        <translation>EPROM 曾解锁，无法确认是否已重新上锁</translation>
    </message>
    <message>
        <source>the result of a write is unknown</source>
        <translation>写入结果未知</translation>
    </message>
    <message>
        <source>voltage alarm</source>
        <translation>过压欠压</translation>
    </message>
    <message>
        <source>temperature alarm</source>
        <translation>过温</translation>
    </message>
    <message>
        <source>overload alarm</source>
        <translation>过载</translation>
    </message>
    <message>
        <source>overcurrent alarm</source>
        <translation>过流</translation>
    </message>
    <message>
        <source>sensor alarm</source>
        <translation>传感器异常</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>Done, see remarks</source>
        <translation>完成，有备注</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translation>剔除</translation>
    </message>
    <message>
        <source>alarm: %1</source>
        <translation>报警：%1</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Settings written</source>
        <translation>写入项数</translation>
    </message>
    <message>
        <source>Unfinished servos</source>
        <translation>未完成的舵机</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>计划值</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>批次</translation>
    </message>
    <message>
        <source>First servo</source>
        <translation>第一个舵机</translation>
    </message>
    <message>
        <source>Last servo</source>
        <translation>最后一个舵机</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>With remarks</source>
        <translation>有备注</translation>
    </message>
    <message>
        <source>Unfinished</source>
        <translation>未完成</translation>
    </message>
    <message>
        <source>Commissioning report</source>
        <translation>批量设置报告</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>电压</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>SIMULATED: not real servos</source>
        <translation>模拟：不是真实舵机</translation>
    </message>
    <message>
        <source>Some of these servos were SIMULATED</source>
        <translation>部分舵机是模拟的，不是真实舵机</translation>
    </message>
</context>
<context>
    <name>ControlText</name>
    <message>
        <source>forward</source>
        <translation>正转</translation>
    </message>
    <message>
        <source>reverse</source>
        <translation>反转</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>顺时针</translation>
    </message>
    <message>
        <source>counterclockwise</source>
        <translation>逆时针</translation>
    </message>
    <message>
        <source>Speed 0 = stop</source>
        <translation>速度 0 = 停止</translation>
    </message>
    <message>
        <source>Speed 0 = stop (phase bit 3)</source>
        <translation>速度 0 = 停止（相位 bit 3）</translation>
    </message>
    <message>
        <source>Speed 0 = maximum (phase bit 3)</source>
        <translation>速度 0 = 最大（相位 bit 3）</translation>
    </message>
    <message>
        <source>Torque is off and stays off.</source>
        <translation>已卸力，并保持卸力。</translation>
    </message>
    <message>
        <source>0 = maximum</source>
        <translation>0 = 最大</translation>
    </message>
    <message>
        <source>Speed 0 = travel time applies</source>
        <translation>速度 0 = 运行时间生效</translation>
    </message>
    <message>
        <source>limited to %1 (%2), the maximum for this model</source>
        <translation>限制为 %1（%2），即此型号的最大值</translation>
    </message>
    <message>
        <source>maximum for this model: %1 (%2)</source>
        <translation>此型号的最大值：%1（%2）</translation>
    </message>
    <message>
        <source>Moves to an angle within the angle limits</source>
        <translation>转到指定角度（在角度限制范围内）</translation>
    </message>
    <message>
        <source>Moves to an angle up to 7.5 turns in either direction; turns are counted from power-on</source>
        <translation>转到指定角度，正反向各不超过 7.5 圈；圈数从上电时算起</translation>
    </message>
    <message>
        <source>Turns continuously and holds its speed under load</source>
        <translation>持续转动，带载时保持速度</translation>
    </message>
    <message>
        <source>Turns continuously; the speed drops under load</source>
        <translation>持续转动；带载时速度下降</translation>
    </message>
    <message>
        <source>Each goal is relative to the present position, up to 7.5 turns in total</source>
        <translation>每个目标都相对于当前位置，总共不超过 7.5 圈</translation>
    </message>
    <message>
        <source>Turns continuously like a motor</source>
        <translation>像电机一样持续转动</translation>
    </message>
    <message>
        <source>Controls the current and thus the torque</source>
        <translation>控制电流，从而控制扭矩</translation>
    </message>
    <message>
        <source>Position control without an integral term (newer firmware); one turn only</source>
        <translation>无积分项的位置控制（较新固件）；仅限一圈</translation>
    </message>
    <message>
        <source>Moves to an angle, then turns torque off</source>
        <translation>转到指定角度后卸力</translation>
    </message>
    <message>
        <source>The angle limits %1 will be saved and then restored when you switch back.</source>
        <translation>将保存角度限制 %1，切换回来时再恢复。</translation>
    </message>
    <message>
        <source>The previous angle limits %1 are restored.</source>
        <translation>恢复之前的角度限制 %1。</translation>
    </message>
    <message>
        <source>No angle limits are saved for this servo, so the factory limits %1 are used.</source>
        <translation>此舵机没有已保存的角度限制，因此使用出厂限制 %1。</translation>
    </message>
    <message>
        <source>Torque is turned off first and stays off until you turn it on.</source>
        <translation>先卸力，并保持卸力，直到您打开扭矩。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is set to 0 to prevent unexpected movement.</source>
        <translation>“%1”设为 0，防止意外转动。</translation>
    </message>
    <message>
        <source>All written values are read back. The mode is kept after power-off.</source>
        <translation>写入的值都会回读确认。断电后模式保持不变。</translation>
    </message>
    <message numerus="yes">
        <source>%n other selected servo(s) will be switched in the same way.</source>
        <translation>
            <numerusform>另外 %n 个选中的舵机也会以同样方式切换。</numerusform>
        </translation>
    </message>
    <message>
        <source>Select a servo on the left. Selecting a servo does not move it.</source>
        <translation>请在左侧选择舵机。选择舵机不会使其运动。</translation>
    </message>
    <message>
        <source>The firmware of this servo is unknown. Measurements are shown, but moving the servo could cause damage. To allow movement, add a model file.</source>
        <translation>此舵机的固件未知。只显示其测量值；驱动此舵机可能造成损坏。添加型号文件后即可驱动。</translation>
    </message>
    <message>
        <source>The settings of this servo could not be read.</source>
        <translation>无法读取此舵机的设置。</translation>
    </message>
    <message>
        <source>Reading the settings of this servo…</source>
        <translation>正在读取此舵机的设置…</translation>
    </message>
</context>
<context>
    <name>EventText</name>
    <message>
        <source>%1 %2 → %3, %4</source>
        <translation>%1 %2 → %3，%4</translation>
    </message>
    <message>
        <source>ID %1 · %2</source>
        <translation>ID %1 · %2</translation>
    </message>
    <message>
        <source>Connected: %1</source>
        <translation>已连接：%1</translation>
    </message>
    <message>
        <source>Port closed: %1</source>
        <translation>端口已关闭：%1</translation>
    </message>
    <message>
        <source>clear alarm</source>
        <translation>解除报警</translation>
    </message>
    <message>
        <source>interrupted writes</source>
        <translation>未写完的更改</translation>
    </message>
    <message>
        <source>read memory table</source>
        <translation>读取内存表</translation>
    </message>
    <message>
        <source>write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>ID %1: </source>
        <translation>ID %1：</translation>
    </message>
    <message>
        <source>TORQUE IS STILL ON: ID %1</source>
        <translation>扭矩仍然打开：ID %1</translation>
    </message>
    <message>
        <source>move</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>扭矩</translation>
    </message>
    <message>
        <source>stop motion</source>
        <translation>停止运动</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>已重做：%1</translation>
    </message>
    <message>
        <source>, NOT RECORDED</source>
        <translation>，未记录</translation>
    </message>
    <message>
        <source>Emergency stop not sent: no port is open.</source>
        <translation>急停未发送：没有打开的端口。</translation>
    </message>
    <message>
        <source>The emergency stop was not sent: no port was open.</source>
        <translation>急停未发送：当时没有打开的端口。</translation>
    </message>
    <message>
        <source>Servos may still be moving. Press Esc to stop them now.</source>
        <translation>舵机可能仍在运动。按 Esc 立即停止。</translation>
    </message>
    <message>
        <source>Closing canceled: ID %1 could not be stopped.</source>
        <translation>已取消关闭：未能使 ID %1 停止。</translation>
    </message>
    <message>
        <source>. Stopped before closing: ID %1</source>
        <translation>。关闭前已停止：ID %1</translation>
    </message>
    <message>
        <source>. STILL MOVING: ID %1</source>
        <translation>。仍在运动：ID %1</translation>
    </message>
    <message>
        <source>goal sent: %1</source>
        <translation>已发送目标：%1</translation>
    </message>
    <message>
        <source>%1: stopped</source>
        <translation>%1：已停止</translation>
    </message>
    <message>
        <source>%1: ended</source>
        <translation>%1：已结束</translation>
    </message>
    <message>
        <source>%1: done</source>
        <translation>%1：完成</translation>
    </message>
    <message>
        <source>%1: running</source>
        <translation>%1：正在进行</translation>
    </message>
    <message>
        <source>sweep test</source>
        <translation>扫描测试</translation>
    </message>
    <message>
        <source>step response</source>
        <translation>阶跃响应</translation>
    </message>
    <message>
        <source>commissioning</source>
        <translation>批量设置</translation>
    </message>
    <message>
        <source>unknown model</source>
        <translation>未知型号</translation>
    </message>
    <message>
        <source>Emergency stop sent, but not confirmed yet: ID %1</source>
        <translation>已发送急停，但尚未确认：ID %1</translation>
    </message>
    <message>
        <source>Check the cable and try again. The unfinished write stays in the journal.</source>
        <translation>请检查线缆后重试。未写完的更改仍保留在写入日志中。</translation>
    </message>
    <message>
        <source>Connect again to finish or undo the write.</source>
        <translation>请重新连接，以完成或撤销该写入。</translation>
    </message>
    <message>
        <source>set midpoint</source>
        <translation>设为中位</translation>
    </message>
    <message>
        <source>blink LED</source>
        <translation>闪烁 LED</translation>
    </message>
    <message>
        <source>reset to factory defaults</source>
        <translation>恢复出厂设置</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>已撤销：%1</translation>
    </message>
    <message>
        <source>, EPROM locked</source>
        <translation>，EPROM 已上锁</translation>
    </message>
    <message>
        <source>, EPROM UNLOCKED</source>
        <translation>，EPROM 未上锁！</translation>
    </message>
    <message>
        <source>, EPROM lock not confirmed</source>
        <translation>，无法确认 EPROM 已上锁</translation>
    </message>
    <message numerus="yes">
        <source>Search ended after %1 s, %n servo(s) found</source>
        <translation>
            <numerusform>搜索结束，用时 %1 秒，找到 %n 个舵机</numerusform>
        </translation>
    </message>
    <message>
        <source>. No reply: ID %1</source>
        <translation>。无应答：ID %1</translation>
    </message>
    <message>
        <source>These servos were expected but did not reply despite several queries.</source>
        <translation>这些舵机本应在总线上，但多次查询均无应答。</translation>
    </message>
    <message>
        <source>A different servo now replies with ID %1: %2</source>
        <translation>现在以 ID %1 应答的是另一个舵机：%2</translation>
    </message>
    <message>
        <source>The new servo replaces %1 in the list. Unfinished writes remain assigned to the previous servo.</source>
        <translation>列表中的 %1 已换成新舵机。未写完的更改仍归原舵机。</translation>
    </message>
    <message>
        <source>no reply: ID %1</source>
        <translation>无应答：ID %1</translation>
    </message>
    <message>
        <source>not reachable (different baud rate): ID %1</source>
        <translation>波特率不同，指令未送达：ID %1</translation>
    </message>
    <message>
        <source>a goal may still be waiting for the Execute command: ID %1</source>
        <translation>可能仍有目标在等待“异步执行”指令：ID %1</translation>
    </message>
    <message>
        <source>Emergency stop confirmed: torque is off, ID %1</source>
        <translation>急停已确认：已卸力，ID %1</translation>
    </message>
    <message>
        <source>Emergency stop not confirmed: %1</source>
        <translation>急停未得到确认：%1</translation>
    </message>
    <message>
        <source>Keep clear. If in doubt, turn off the power supply.</source>
        <translation>请远离舵机，如有疑问请断开电源。</translation>
    </message>
    <message>
        <source>Servos may still be moving. Turn off their power supply.</source>
        <translation>舵机可能仍在运动，请切断其电源。</translation>
    </message>
    <message>
        <source>Emergency stop: torque-off command sent to all servos</source>
        <translation>急停：已向全部舵机发送卸力指令</translation>
    </message>
    <message>
        <source>Emergency stop not sent yet: the connection is lost.</source>
        <translation>急停尚未发送：连接已断开。</translation>
    </message>
    <message>
        <source>When the connection is restored, the emergency stop will be sent first.</source>
        <translation>连接恢复后会首先发送急停。</translation>
    </message>
    <message>
        <source>Press Esc to turn torque off, or turn off the power supply.</source>
        <translation>按 Esc 卸力，或切断电源。</translation>
    </message>
    <message>
        <source>Closing canceled: the EPROM of ID %1 is still unlocked.</source>
        <translation>已取消关闭：ID %1 的 EPROM 仍未上锁。</translation>
    </message>
    <message>
        <source>Turn off the power supply to stop the motion.</source>
        <translation>要停止运动，请切断电源。</translation>
    </message>
    <message>
        <source>. EPROM locked: ID %1</source>
        <translation>。EPROM 已上锁：ID %1</translation>
    </message>
    <message>
        <source>. EPROM STILL UNLOCKED: ID %1</source>
        <translation>。EPROM 仍未上锁：ID %1</translation>
    </message>
    <message>
        <source>goal follows the slider</source>
        <translation>目标跟随滑块</translation>
    </message>
    <message>
        <source>ID %1 · memory table saved before the first change: %2</source>
        <translation>ID %1 · 首次更改前已保存内存表：%2</translation>
    </message>
    <message>
        <source>reboot</source>
        <translation>重启舵机</translation>
    </message>
    <message>
        <source>execute waiting goals</source>
        <translation>异步执行</translation>
    </message>
    <message>
        <source>change mode</source>
        <translation>切换模式</translation>
    </message>
    <message>
        <source>preview mode change</source>
        <translation>预览模式切换</translation>
    </message>
    <message>
        <source>lock the EPROM</source>
        <translation>EPROM 上锁</translation>
    </message>
    <message>
        <source>restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>take snapshot</source>
        <translation>保存快照</translation>
    </message>
    <message>
        <source>dry run</source>
        <translation>预演</translation>
    </message>
    <message>
        <source>search for unused IDs</source>
        <translation>查找空闲 ID</translation>
    </message>
    <message>
        <source>verify emergency stop</source>
        <translation>确认急停已生效</translation>
    </message>
    <message>
        <source>check for motion</source>
        <translation>检查是否仍在运动</translation>
    </message>
    <message>
        <source>check before the firmware update</source>
        <translation>固件更新前检查</translation>
    </message>
    <message>
        <source>update firmware</source>
        <translation>更新固件</translation>
    </message>
    <message>
        <source>rescue firmware</source>
        <translation>救援固件</translation>
    </message>
    <message>
        <source>record joint ranges</source>
        <translation>采集关节范围</translation>
    </message>
    <message>
        <source>calibrate arm</source>
        <translation>校准机械臂</translation>
    </message>
    <message>
        <source>move test</source>
        <translation>运动测试</translation>
    </message>
</context>
<context>
    <name>Feedback</name>
    <message>
        <source>Voltage</source>
        <translation>电压</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>负载</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>limit %1</source>
        <comment>torque limit in %</comment>
        <translation>限值 %1</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未读取</translation>
    </message>
    <message>
        <source>Voltage out of range</source>
        <translation>过压欠压</translation>
    </message>
    <message>
        <source>Sensor fault</source>
        <translation>传感器异常</translation>
    </message>
    <message>
        <source>Over-temperature</source>
        <translation>过温</translation>
    </message>
    <message>
        <source>Overcurrent</source>
        <translation>过流</translation>
    </message>
    <message>
        <source>Angle fault</source>
        <translation>角度异常</translation>
    </message>
    <message>
        <source>Overload</source>
        <translation>过载</translation>
    </message>
    <message>
        <source>remaining distance</source>
        <translation>剩余距离</translation>
    </message>
</context>
<context>
    <name>History</name>
    <message>
        <source>temporary write</source>
        <translation>临时写入</translation>
    </message>
    <message>
        <source>write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>set ID</source>
        <translation>设置 ID</translation>
    </message>
    <message>
        <source>change mode</source>
        <translation>切换模式</translation>
    </message>
    <message>
        <source>restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>试用</translation>
    </message>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>已撤销</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>before a change</source>
        <translation>修改之前</translation>
    </message>
    <message>
        <source>Writes</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>快照</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Servos</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Old</source>
        <translation>原值</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新值</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行数</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作员</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>Last write</source>
        <translation>最近写入</translation>
    </message>
    <message>
        <source>step response</source>
        <translation>阶跃响应</translation>
    </message>
    <message>
        <source>sweep test</source>
        <translation>扫描测试</translation>
    </message>
    <message>
        <source>undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>before commissioning</source>
        <translation>批量设置前</translation>
    </message>
    <message>
        <source>blink LED</source>
        <translation>闪烁 LED</translation>
    </message>
    <message>
        <source>set baud rate</source>
        <translation>设置波特率</translation>
    </message>
    <message>
        <source>set midpoint</source>
        <translation>设为中位</translation>
    </message>
    <message>
        <source>reset to factory defaults</source>
        <translation>恢复出厂设置</translation>
    </message>
    <message>
        <source>unfinished</source>
        <translation>未写完</translation>
    </message>
    <message>
        <source>abandoned</source>
        <translation>已放弃</translation>
    </message>
    <message>
        <source>manual</source>
        <translation>手动保存</translation>
    </message>
    <message>
        <source>bundle</source>
        <translation>整组快照</translation>
    </message>
    <message>
        <source>Raised</source>
        <translation>出现</translation>
    </message>
    <message>
        <source>Cleared</source>
        <translation>解除</translation>
    </message>
    <message>
        <source>still active</source>
        <translation>尚未解除</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>回读</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>This alarm is derived from the limits, not reported by the servo.</source>
        <translation>此报警根据限值判定，并非由舵机报告。</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>This servo is not connected.</source>
        <translation>此舵机未连接。</translation>
    </message>
    <message>
        <source>To change the ID or baud rate back, use Servo → Set ID or Servo → Set baud rate.</source>
        <translation>要改回 ID 或波特率，请使用“舵机 → 设置 ID”或“舵机 → 设置波特率”。</translation>
    </message>
    <message>
        <source>This entry is an action, not a value that can be written back.</source>
        <translation>此条目是一项操作，没有可以写回的值。</translation>
    </message>
    <message>
        <source>The register already holds the old value.</source>
        <translation>该参数已是原值。</translation>
    </message>
    <message>
        <source>Undo this write?</source>
        <translation>撤销此次写入？</translation>
    </message>
    <message>
        <source>ID %1 · %2: %3 will change from %4 to %5.</source>
        <translation>ID %1 · %2：%3 将从 %4 改为 %5。</translation>
    </message>
    <message>
        <source>The value was changed again after this write.</source>
        <translation>此次写入之后，该值又被更改过。</translation>
    </message>
    <message>
        <source>Undo this write</source>
        <translation>撤销此次写入</translation>
    </message>
</context>
<context>
    <name>MemorySheet</name>
    <message>
        <source>Memory table of %1, ID %2</source>
        <translation>%1 的内存表，ID %2</translation>
    </message>
    <message>
        <source>Firmware %1, register map %2</source>
        <translation>固件 %1，内存表 %2</translation>
    </message>
    <message>
        <source>Port %1, %2 baud</source>
        <translation>端口 %1，波特率 %2</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>键名</translation>
    </message>
    <message>
        <source>Created %1</source>
        <translation>生成时间 %1</translation>
    </message>
</context>
<context>
    <name>MemoryTable</name>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Physical</source>
        <translation>物理值</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>存储区域</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>读写</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>%1: was %2 when first read in this session</source>
        <translation>%1：本次会话中首次读取时为 %2</translation>
    </message>
    <message>
        <source>No default is known for this model.</source>
        <translation>该型号的默认值未知。</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未读取</translation>
    </message>
    <message>
        <source>pending: %1</source>
        <translation>待写入：%1</translation>
    </message>
    <message>
        <source>This register has not been read yet. Choose Read all.</source>
        <translation>该参数还没有读取。请点击“读取全部”。</translation>
    </message>
    <message>
        <source>The value was read from the servo.</source>
        <translation>已从舵机读取该值。</translation>
    </message>
    <message>
        <source>%1 is being written.</source>
        <translation>正在写入 %1。</translation>
    </message>
    <message>
        <source>%1 was written and read back; it is lost at power-off.</source>
        <translation>已写入 %1 并回读确认；断电后丢失。</translation>
    </message>
    <message>
        <source>now</source>
        <translation>刚刚</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 小时</translation>
    </message>
    <message>
        <source>The value shown was read %1 ago.</source>
        <translation>显示的是 %1前读取的值。</translation>
    </message>
    <message>
        <source>%1. A wrong value can make the servo unreachable or dangerous. ServoDesk asks for confirmation before each write.</source>
        <translation>%1。写错数值可能导致舵机失联或造成危险。每次写入前 ServoDesk 都会要求确认。</translation>
    </message>
    <message>
        <source>Address in the servo&apos;s memory table</source>
        <translation>舵机内存表中的地址</translation>
    </message>
    <message>
        <source>Register name; • marks a value that differs from the first reading of this session</source>
        <translation>参数名称；• 表示当前值与本次会话中首次读取的值不同</translation>
    </message>
    <message>
        <source>Raw value as read from the servo</source>
        <translation>舵机中读出的原始值</translation>
    </message>
    <message>
        <source>Raw value converted to physical units, or the name it stands for</source>
        <translation>原始值换算后的物理量，或其对应的名称</translation>
    </message>
    <message>
        <source>Memory area: EPROM (kept after power-off), SRAM (lost at power-off), feedback (measured) or factory (set by the manufacturer)</source>
        <translation>存储区域：EPROM（断电后保留）、SRAM（断电后丢失）、反馈（实测值）或出厂（由厂家设定）</translation>
    </message>
    <message>
        <source>r: read-only; rw: read/write; ⚠: requires confirmation for each write</source>
        <translation>⚠：每次写入需要确认</translation>
    </message>
    <message>
        <source>Factory value; empty if unknown</source>
        <translation>出厂值；未知则为空</translation>
    </message>
    <message>
        <source>Values that can be written</source>
        <translation>允许写入的值</translation>
    </message>
    <message>
        <source>Result of the last write and age of the value</source>
        <translation>最近一次写入的结果，以及距上次读取的时间</translation>
    </message>
    <message>
        <source>This register cannot be written.</source>
        <translation>此参数不能写入。</translation>
    </message>
    <message>
        <source>Values that can be written: %1</source>
        <translation>可写入的值：%1</translation>
    </message>
    <message>
        <source>could not be read</source>
        <translation>读取失败</translation>
    </message>
    <message>
        <source>write: no reply</source>
        <translation>写入：无应答</translation>
    </message>
    <message>
        <source>changed since the write</source>
        <translation>写入后值已改变</translation>
    </message>
    <message>
        <source>The last read failed, so no value is shown.</source>
        <translation>最近一次读取失败，因此不显示数值。</translation>
    </message>
    <message>
        <source>%1 was written and read back; it is kept after power-off.</source>
        <translation>已写入 %1 并回读确认；断电后保留。</translation>
    </message>
    <message>
        <source>%1 was written, but the servo reports a different value.</source>
        <translation>已写入 %1，但舵机报告的是另一个值。</translation>
    </message>
    <message>
        <source>The servo did not accept %1.</source>
        <translation>舵机没有接受 %1。</translation>
    </message>
    <message>
        <source>No reply while writing %1.</source>
        <translation>写入 %1 时没有应答。</translation>
    </message>
    <message>
        <source>The result of writing %1 is unknown. Read the register again.</source>
        <translation>写入 %1 的结果未知。请重新读取该参数。</translation>
    </message>
    <message>
        <source>%1 was not written. The servo was not changed.</source>
        <translation>未写入 %1，舵机没有变化。</translation>
    </message>
    <message>
        <source>%1 was written, but the servo has since reported a different value. Either a temporary value was lost at power-off, or another program wrote to the servo.</source>
        <translation>曾写入 %1，但之后舵机报告了另一个值。可能是临时值因断电丢失，或有其他程序写入了该舵机。</translation>
    </message>
    <message>
        <source>The value shown was read just now.</source>
        <translation>显示的是刚刚读取的值。</translation>
    </message>
    <message>
        <source>r</source>
        <comment>read-only</comment>
        <translation>只读</translation>
    </message>
    <message>
        <source>rw</source>
        <comment>read/write</comment>
        <translation>读写</translation>
    </message>
</context>
<context>
    <name>Options</name>
    <message>
        <source>baud rate of the port, or auto</source>
        <translation>端口波特率，或 auto</translation>
    </message>
    <message>
        <source>protocol: auto, feetech, modbus or lx</source>
        <translation>协议：auto、feetech、modbus 或 lx</translation>
    </message>
    <message>
        <source>language of the interface: en or zh_CN</source>
        <translation>界面语言：en 或 zh_CN</translation>
    </message>
    <message>
        <source>color theme: system, light or dark</source>
        <translation>界面主题：system、light 或 dark</translation>
    </message>
    <message>
        <source>ID of the servo to select</source>
        <translation>要选中的舵机 ID</translation>
    </message>
    <message>
        <source>Setup and test program for serial bus servos</source>
        <translation>串行总线舵机调试程序</translation>
    </message>
    <message>
        <source>port to open and search: device path, tcp://HOST:PORT or sim:demo</source>
        <translation>要打开并搜索的端口：设备路径、tcp://主机:端口或 sim:demo</translation>
    </message>
    <message>
        <source>save a screenshot of the window to this PNG file and quit</source>
        <translation>把窗口截图保存到此 PNG 文件后退出</translation>
    </message>
    <message>
        <source>window size, for example 1280x800</source>
        <translation>窗口大小，如 1280x800</translation>
    </message>
    <message>
        <source>delay before the screenshot, in milliseconds</source>
        <translation>截图前等待的毫秒数</translation>
    </message>
    <message>
        <source>--%1: &quot;%2&quot; is not a valid number</source>
        <translation>--%1：“%2”不是有效的数字</translation>
    </message>
    <message>
        <source>--protocol: unknown value &quot;%1&quot;</source>
        <translation>--protocol：未知的值“%1”</translation>
    </message>
    <message>
        <source>--size: &quot;%1&quot; is not a valid window size (for example, 1280x800)</source>
        <translation>--size：“%1”不是有效的窗口大小（如 1280x800）</translation>
    </message>
    <message>
        <source>--theme: unknown value &quot;%1&quot;</source>
        <translation>--theme：未知的值“%1”</translation>
    </message>
    <message>
        <source>--page: unknown value &quot;%1&quot;</source>
        <translation>--page：未知的值“%1”</translation>
    </message>
    <message>
        <source>page to show: operate, memory, sweep, step, snapshots, commission, arm, firmware, history</source>
        <translation>要显示的页面：operate, memory, sweep, step, snapshots, commission, arm, firmware, history</translation>
    </message>
    <message>
        <source>try the program on a simulated bus, with data of its own, and quit</source>
        <translation>在模拟总线上用独立的数据自检，然后退出</translation>
    </message>
    <message>
        <source>snapshots, bundles and recordings to open</source>
        <translation>要打开的快照、整组快照和录制文件</translation>
    </message>
    <message>
        <source>%1: no such file</source>
        <translation>%1：文件不存在</translation>
    </message>
</context>
<context>
    <name>RegisterHelp</name>
    <message>
        <source>Resolution: %1</source>
        <translation>分辨率：%1</translation>
    </message>
    <message>
        <source>Range: %1</source>
        <translation>范围：%1</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>默认：%1</translation>
    </message>
    <message>
        <source>The meaning of this value depends on: %1.</source>
        <translation>该值的含义取决于：%1。</translation>
    </message>
    <message>
        <source>Kept after power-off: ServoDesk writes the value, reads it back and sends the save command.</source>
        <translation>断电后保留：ServoDesk 写入、回读并发送保存指令。</translation>
    </message>
    <message>
        <source>Torque must be off for this write. ServoDesk turns it off first.</source>
        <translation>写入时必须卸力。ServoDesk 会先卸力。</translation>
    </message>
    <message>
        <source>Setting both angle limits to 0 switches the operating mode. ServoDesk turns torque off first.</source>
        <translation>两个角度限制都设为 0 时会切换运行模式。ServoDesk 会先卸力。</translation>
    </message>
    <message>
        <source>Default: unknown</source>
        <translation>默认：未知</translation>
    </message>
    <message>
        <source>The register that determines the meaning has not been read, so the default unit is shown.</source>
        <translation>决定其含义的参数尚未读取，因此按默认单位显示。</translation>
    </message>
    <message>
        <source>Registers that depend on this one: %1.</source>
        <translation>受其影响的参数：%1。</translation>
    </message>
    <message>
        <source>This servo has no sensor for this value, so the number is meaningless.</source>
        <translation>该舵机没有相应的传感器，因此该数值无意义。</translation>
    </message>
    <message>
        <source>Writing this register may move the shaft or turn torque on.</source>
        <translation>写入此参数可能使输出轴转动，或打开扭矩。</translation>
    </message>
    <message>
        <source>Kept after power-off: ServoDesk unlocks the EPROM, writes the value, reads it back and locks the EPROM again.</source>
        <translation>断电后保留：ServoDesk 自动解锁 EPROM、写入、回读并重新上锁。</translation>
    </message>
    <message>
        <source>Kept after power-off: this family stores every write immediately. ServoDesk reads the value back.</source>
        <translation>断电后保留：该系列每次写入都立即保存。ServoDesk 会回读确认。</translation>
    </message>
    <message>
        <source>Takes effect immediately and is lost at power-off.</source>
        <translation>立即生效，断电后丢失。</translation>
    </message>
    <message>
        <source>Takes effect immediately. Whether the value is kept after power-off is not documented.</source>
        <translation>立即生效。资料没有说明断电后是否保留。</translation>
    </message>
</context>
<context>
    <name>RestoreText</name>
    <message>
        <source>%1 (value unknown)</source>
        <translation>%1（数值未知）</translation>
    </message>
    <message>
        <source>%1 (last reading: %2)</source>
        <translation>%1（最近读到：%2）</translation>
    </message>
    <message>
        <source>The old values could not be restored: %1.</source>
        <translation>未能恢复原值：%1。</translation>
    </message>
    <message>
        <source>Read the memory table, then write the remaining rows; the journal lists their values.</source>
        <translation>请重新读取内存表，再写入其余各行；各行的数值见写入日志。</translation>
    </message>
    <message>
        <source>When the servo replies again, open Port → Interrupted writes and choose Undo to restore the old values.</source>
        <translation>舵机恢复应答后，请打开“端口 → 未写完的更改”，选择“撤销”以恢复原值。</translation>
    </message>
    <message>
        <source>The snapshot saved before the first write contains the old values.</source>
        <translation>首次写入前保存的快照中有原值。</translation>
    </message>
    <message>
        <source>The EPROM is unlocked.</source>
        <translation>EPROM 未上锁。</translation>
    </message>
    <message>
        <source>The EPROM lock could not be confirmed.</source>
        <translation>无法确认 EPROM 已上锁。</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) written and read back</source>
        <translation>
            <numerusform>已写入并回读 %n 行</numerusform>
        </translation>
    </message>
    <message>
        <source>Not written or not confirmed: %1.</source>
        <translation>未写入或未确认：%1。</translation>
    </message>
</context>
<context>
    <name>ServoObstacle</name>
    <message>
        <source>Set up servos one at a time</source>
        <translation>逐个接上并设置舵机</translation>
    </message>
    <message>
        <source>Several servos seem to reply with ID %1, so none of them can be read. New servos all have the same ID: connect them one at a time and give each its own.</source>
        <translation>似乎有多个舵机以 ID %1 应答，因此都无法读取。新舵机的 ID 都相同：请逐个连接，并为每个舵机设置各自的 ID。</translation>
    </message>
    <message>
        <source>This servo replies but does not report its model, so it can be neither moved nor configured. Search again.</source>
        <translation>该舵机有应答，但未报告型号，因此无法控制或设置。请重新搜索。</translation>
    </message>
</context>
<context>
    <name>ServoRow</name>
    <message>
        <source>temperature</source>
        <translation>过温</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>过压欠压</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未读取</translation>
    </message>
    <message>
        <source>not identified</source>
        <translation>未识别</translation>
    </message>
    <message>
        <source>Two servos with this ID?</source>
        <translation>疑似 ID 重复</translation>
    </message>
    <message>
        <source>now</source>
        <comment>last seen</comment>
        <translation>刚刚</translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation>%1 秒前</translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation>%1 分钟前</translation>
    </message>
    <message>
        <source>Unknown servo</source>
        <translation>未知舵机</translation>
    </message>
    <message>
        <source>fw %1</source>
        <translation>固件 %1</translation>
    </message>
    <message>
        <source>ID %1 · %2</source>
        <translation>ID %1 · %2</translation>
    </message>
    <message>
        <source>State: %1</source>
        <translation>状态：%1</translation>
    </message>
    <message>
        <source>Firmware: %1</source>
        <translation>固件：%1</translation>
    </message>
    <message>
        <source>Register map: %1</source>
        <translation>内存表：%1</translation>
    </message>
    <message>
        <source>Protocol: %1</source>
        <translation>协议：%1</translation>
    </message>
    <message>
        <source>Baud rate: %1</source>
        <translation>波特率：%1</translation>
    </message>
    <message>
        <source>Last seen: %1</source>
        <translation>最近应答：%1</translation>
    </message>
    <message>
        <source>Family unclear: read-only</source>
        <translation>系列不明：只读</translation>
    </message>
    <message>
        <source>Unknown firmware: read-only</source>
        <translation>未知固件：只读</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>no reply</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>replies cannot be decoded</source>
        <translation>应答无法解析</translation>
    </message>
    <message>
        <source>EPROM unlocked</source>
        <translation>EPROM 未上锁</translation>
    </message>
    <message>
        <source>EPROM lock not confirmed</source>
        <translation>未确认 EPROM 已上锁</translation>
    </message>
    <message>
        <source>EPROM unlocked by ServoDesk</source>
        <translation>EPROM 未上锁（由 ServoDesk 解锁）</translation>
    </message>
    <message>
        <source>EPROM unlocked by ServoDesk; relocking not confirmed</source>
        <translation>EPROM 由 ServoDesk 解锁，未确认已重新上锁</translation>
    </message>
    <message>
        <source>Replies late</source>
        <translation>应答迟缓</translation>
    </message>
    <message>
        <source>Newer firmware exists: %1 (%2)</source>
        <translation>已有较新固件：%1（%2）</translation>
    </message>
    <message>
        <source>Bus type: %1</source>
        <translation>总线类型：%1</translation>
    </message>
    <message>
        <source>Firmware differs from the others</source>
        <translation>固件版本与其他舵机不同</translation>
    </message>
</context>
<context>
    <name>ServoTasks</name>
    <message>
        <source>The alarm has cleared.</source>
        <translation>报警已解除。</translation>
    </message>
    <message>
        <source>Reset fault</source>
        <translation>故障复位</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>解除</translation>
    </message>
    <message>
        <source>Clear alarm</source>
        <translation>解除报警</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>The alarms have not been read.</source>
        <translation>尚未读取报警。</translation>
    </message>
    <message>
        <source>Turn back</source>
        <translation>往回转</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>After</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Interrupted writes</source>
        <translation>未写完的更改</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>继续写完</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Forget…</source>
        <translation>放弃处理…</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>稍后处理</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>正在处理…</translation>
    </message>
    <message>
        <source>Forget this change?</source>
        <translation>放弃处理这次更改？</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>放弃处理</translation>
    </message>
    <message>
        <source>The change has been completed.</source>
        <translation>更改已完成。</translation>
    </message>
    <message>
        <source>ID %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>set ID</source>
        <translation>设置 ID</translation>
    </message>
    <message>
        <source>set baud rate</source>
        <translation>设置波特率</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>EPROM lock</source>
        <translation>EPROM 锁</translation>
    </message>
    <message>
        <source>The reboot took %1 ms. Torque is off.</source>
        <translation>重启耗时 %1 毫秒。已卸力。</translation>
    </message>
    <message>
        <source>The factory defaults have been restored.</source>
        <translation>已恢复出厂设置。</translation>
    </message>
    <message>
        <source>ID: %1 → %2, baud rate: %3 → %4</source>
        <translation>ID：%1 → %2，波特率：%3 → %4</translation>
    </message>
    <message>
        <source>Set baud rate</source>
        <translation>设置波特率</translation>
    </message>
    <message>
        <source>New baud rate:</source>
        <translation>新波特率：</translation>
    </message>
    <message>
        <source>New baud rate</source>
        <translation>新波特率</translation>
    </message>
    <message>
        <source>The baud rate has been changed.</source>
        <translation>波特率已修改。</translation>
    </message>
    <message>
        <source>%1 — free</source>
        <translation>%1 — 空闲</translation>
    </message>
    <message>
        <source>%1 — this servo (%2)</source>
        <translation>%1 — 本舵机（%2）</translation>
    </message>
    <message>
        <source>%1 — taken by %2</source>
        <translation>%1 — 已被 %2 占用</translation>
    </message>
    <message>
        <source>Set ID</source>
        <translation>设置 ID</translation>
    </message>
    <message>
        <source>New ID:</source>
        <translation>新 ID：</translation>
    </message>
    <message>
        <source>New ID</source>
        <translation>新 ID</translation>
    </message>
    <message>
        <source>The new ID, %1 to %2</source>
        <translation>新 ID，范围 %1～%2</translation>
    </message>
    <message>
        <source>IDs on this bus</source>
        <translation>总线上的 ID</translation>
    </message>
    <message>
        <source>The ID has been changed.</source>
        <translation>ID 已修改。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>unknown model</source>
        <translation>未知型号</translation>
    </message>
    <message>
        <source>firmware %1</source>
        <translation>固件 %1</translation>
    </message>
    <message>
        <source>EPROM lock: %1</source>
        <translation>EPROM 锁：%1</translation>
    </message>
    <message>
        <source>Likely cause: %1</source>
        <translation>可能原因：%1</translation>
    </message>
    <message>
        <source>The servo replies as ID %1 at %2 baud.</source>
        <translation>舵机现以 ID %1、波特率 %2 应答。</translation>
    </message>
    <message>
        <source>restore a snapshot</source>
        <translation>恢复快照</translation>
    </message>
    <message>
        <source>undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>%1, %2: %3, port %4, %5</source>
        <translation>%1，%2：%3，端口 %4，%5</translation>
    </message>
    <message>
        <source>the old values</source>
        <translation>原值</translation>
    </message>
    <message>
        <source>the new values</source>
        <translation>新值</translation>
    </message>
    <message>
        <source>Turn back slightly…</source>
        <translation>往回转一点…</translation>
    </message>
    <message>
        <source>Hold position…</source>
        <translation>保持当前位置…</translation>
    </message>
    <message>
        <source>Each alarm is cleared in its own way. While this dialog is open, the values are read continuously; nothing is written to the servo.</source>
        <translation>每种报警有各自的解除方式。此对话框打开期间会持续读取数值，不会写入舵机。</translation>
    </message>
    <message>
        <source>Performs the action that clears the alarm</source>
        <translation>执行解除报警的操作</translation>
    </message>
    <message>
        <source>Alarms of this servo, each with its value and limits</source>
        <translation>该舵机的报警，以及各自的数值和限值</translation>
    </message>
    <message>
        <source>This servo family does not report alarms. This alarm is derived from the value and its limit.</source>
        <translation>该系列舵机不上报报警；此报警根据数值和限值判断得出。</translation>
    </message>
    <message>
        <source>Turn the shaft back?</source>
        <translation>让输出轴往回转？</translation>
    </message>
    <message>
        <source>The shaft will turn from %1 to %2, away from the stalled position, and hold the new position at full torque.</source>
        <translation>输出轴将从 %1 转到 %2，离开堵转位置，并以最大扭矩保持在该位置。</translation>
    </message>
    <message>
        <source>Turn torque on?</source>
        <translation>打开扭矩？</translation>
    </message>
    <message>
        <source>The present position, %1, will become the goal position, and the servo will hold it.</source>
        <translation>当前位置 %1 将设为目标位置，舵机会保持在该位置。</translation>
    </message>
    <message>
        <source>Turn torque on</source>
        <translation>打开扭矩</translation>
    </message>
    <message>
        <source>Remove the obstruction and keep your fingers away from the mechanism.</source>
        <translation>请先排除卡阻，手指远离机构，防止夹手。</translation>
    </message>
    <message>
        <source>An alarm is still active or has returned because its cause remains.</source>
        <translation>报警原因尚未消除，报警仍在或再次出现。</translation>
    </message>
    <message>
        <source>This servo does not support this action.</source>
        <translation>该舵机不支持此操作。</translation>
    </message>
    <message>
        <source>Set midpoint</source>
        <translation>设为中位</translation>
    </message>
    <message>
        <source>The present shaft position becomes the midpoint of the travel range. Torque is turned off first to prevent a jump to the old goal position and stays off until you turn it on. The position correction is kept after power-off.</source>
        <translation>输出轴的当前位置将成为转动范围的中位。会先卸力，以免舵机跳向原目标位置；之后保持卸力，直到您打开扭矩。位置校正在断电后保留。</translation>
    </message>
    <message>
        <source>Turns torque off and sets the present position as the midpoint</source>
        <translation>卸力，并把当前位置设为中位</translation>
    </message>
    <message>
        <source>The present position is now the midpoint.</source>
        <translation>当前位置已设为中位。</translation>
    </message>
    <message>
        <source>Blink LED</source>
        <translation>闪烁 LED</translation>
    </message>
    <message>
        <source>This servo&apos;s LED blinks for a few seconds, and then the LED setting is restored. The servo does not move. If the servo has no LED, you will not see anything.</source>
        <translation>该舵机的 LED 会闪烁几秒，然后恢复原来的设置。舵机不会转动。如果舵机没有 LED，则看不到任何变化。</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>重复</translation>
    </message>
    <message>
        <source>Blinks the LED again</source>
        <translation>让 LED 再次闪烁</translation>
    </message>
    <message>
        <source>The LED setting has been restored.</source>
        <translation>LED 设置已恢复原样。</translation>
    </message>
    <message>
        <source>These registers were not written because their values have changed in the meantime or because writing them would move the servo: %1</source>
        <translation>以下参数未写入，因为其数值后来又有变动，或写入会使舵机转动：%1</translation>
    </message>
    <message>
        <source>Nothing was written. ServoDesk will no longer offer to finish or undo this change.</source>
        <translation>没有写入任何内容。ServoDesk 不再提示完成或撤销此更改。</translation>
    </message>
    <message>
        <source>The servo already has the settings from before the test. Nothing needed to be restored.</source>
        <translation>舵机的设置已与测试前一致，无需恢复。</translation>
    </message>
    <message>
        <source>The settings from before the test have been restored.</source>
        <translation>已恢复测试前的设置。</translation>
    </message>
    <message>
        <source>The old values have been restored.</source>
        <translation>原值已恢复。</translation>
    </message>
    <message>
        <source>Changes that were started but not finished are listed here. Possible causes: a cable was pulled, the power failed, or the program was terminated.</source>
        <translation>因拔线、断电或程序被终止而未写完的更改会列在这里。</translation>
    </message>
    <message>
        <source>Another program is still making these changes, so ServoDesk does not touch them. If that program ends before the changes are complete, they will be listed here.</source>
        <translation>另一个程序仍在写入这些更改，因此 ServoDesk 不会干预。如果该程序没有写完就结束，未写完的更改会在此列出。</translation>
    </message>
    <message>
        <source>These changes were started but not finished because a cable was pulled, the power failed, or the program was terminated. ServoDesk has only checked them; nothing was written. Choose what to do with each change. Postponed changes will be listed again the next time you connect.</source>
        <translation>这些更改因拔线、断电或程序被终止而未写完。ServoDesk 只做了检查，没有写入任何内容。请逐项选择处理方式。推迟的更改会在下次连接时再次列出。</translation>
    </message>
    <message>
        <source>If another program is still making a change, ServoDesk leaves the change to that program.</source>
        <translation>如果另一个程序仍在写入某项更改，则由该程序完成，ServoDesk 不会干预。</translation>
    </message>
    <message>
        <source>Restores the old values, verifies them, and locks the EPROM</source>
        <translation>恢复原值，回读确认，并给 EPROM 上锁</translation>
    </message>
    <message>
        <source>Marks the change as abandoned in the journal; the servo stays as it is</source>
        <translation>在写入日志中把此更改标记为已放弃；舵机保持现状</translation>
    </message>
    <message>
        <source>Closes this list; writes nothing</source>
        <translation>关闭此列表；不写入任何内容</translation>
    </message>
    <message>
        <source>Search this port</source>
        <translation>搜索此端口</translation>
    </message>
    <message>
        <source>Reads the servos on this port and compares them with these changes; writes nothing</source>
        <translation>读取此端口上的舵机并与这些更改对比；不写入任何内容</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Restores the settings from before the test and verifies them</source>
        <translation>恢复测试前的设置并回读确认</translation>
    </message>
    <message>
        <source>Writes and verifies the missing values and locks the EPROM; afterwards, Undo can revert the whole change</source>
        <translation>写入尚未写入的值，回读确认，并给 EPROM 上锁；之后可用“撤销”还原整个更改</translation>
    </message>
    <message>
        <source>ServoDesk will no longer offer to finish or undo this change. The servo stays as it is.</source>
        <translation>ServoDesk 将不再提示完成或撤销此更改。舵机保持现状。</translation>
    </message>
    <message>
        <source>The EPROM may be unlocked, and the servo may have some old and some new values.</source>
        <translation>EPROM 可能没有上锁，舵机中的数值可能一部分是原值、一部分是新值。</translation>
    </message>
    <message>
        <source>No unfinished changes.</source>
        <translation>没有未写完的更改。</translation>
    </message>
    <message>
        <source>Nothing was written because the change is no longer listed as unfinished, or because the port where it was started is available again.</source>
        <translation>未写入任何内容：该更改已不在未写完之列，或原来的端口已重新可用。</translation>
    </message>
    <message>
        <source>Unfinished changes from other ports. If the adapter&apos;s port name has changed, search the new port for the servos:</source>
        <translation>以下更改在其他端口上开始，尚未写完。如果适配器的端口名已改变，请在新端口上搜索舵机：</translation>
    </message>
    <message>
        <source>Unfinished changes from other ports. To finish or undo a change, connect to its port:</source>
        <translation>以下更改在其他端口上开始，尚未写完。请连接到相应端口，以完成或撤销：</translation>
    </message>
    <message>
        <source>The change is still unfinished and will be listed again.</source>
        <translation>该更改仍未写完，之后会再次列出。</translation>
    </message>
    <message>
        <source>change mode</source>
        <translation>切换模式</translation>
    </message>
    <message>
        <source>set midpoint</source>
        <translation>设为中位</translation>
    </message>
    <message>
        <source>change settings for a test</source>
        <translation>为测试更改设置</translation>
    </message>
    <message>
        <source>different servo or values; skipped</source>
        <translation>舵机或数值不符，已跳过</translation>
    </message>
    <message>
        <source>Current state</source>
        <translation>现状</translation>
    </message>
    <message>
        <source>Reboot servo</source>
        <translation>重启舵机</translation>
    </message>
    <message>
        <source>Torque is turned off first, so a load held by the servo will drop. Temporarily written values and the turn count are lost. ServoDesk keeps the whole bus quiet for up to two seconds until the servo replies again.</source>
        <translation>会先卸力，舵机托住的负载会落下。临时写入的值和圈数都会丢失。舵机恢复应答之前，ServoDesk 会让整条总线保持静默，最多两秒。</translation>
    </message>
    <message>
        <source>Reboot</source>
        <translation>重启</translation>
    </message>
    <message>
        <source>Turns torque off, reboots the servo and waits for its reply</source>
        <translation>卸力后重启舵机并等待其应答</translation>
    </message>
    <message>
        <source>The servo has rebooted and is replying again.</source>
        <translation>舵机已重启并恢复应答。</translation>
    </message>
    <message>
        <source>No settings have changed.</source>
        <translation>设置没有变化。</translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) changed: %1</source>
        <translation>
            <numerusform>%n 项设置与之前不同：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Reset to factory defaults</source>
        <translation>恢复出厂设置</translation>
    </message>
    <message>
        <source>The servo returns to its stored default settings. ServoDesk first turns torque off and saves the present memory table to a file.</source>
        <translation>舵机恢复为其内部存储的默认参数。ServoDesk 先卸力，并把当前内存表保存到文件。</translation>
    </message>
    <message>
        <source>Save and reset</source>
        <translation>保存并恢复出厂设置</translation>
    </message>
    <message>
        <source>Saves the memory table, resets the servo to factory defaults, and then finds the servo again</source>
        <translation>保存内存表，恢复出厂设置，然后重新查找舵机</translation>
    </message>
    <message>
        <source>Baud rate: may revert to the stored rate. ServoDesk searches for the servo at all baud rates of its family.
ID: should stay the same; some servos revert to 1. If another servo has ID 1, connect only this servo.
Limits, gains and position correction: will be reset; afterwards, the same position may correspond to a different angle.</source>
        <translation>波特率：可能恢复为舵机内存储的值；ServoDesk 会用该系列的各个波特率逐一查找舵机。
ID：一般不变；个别舵机会恢复为 1。如果另有舵机使用 ID 1，请只连接要恢复的舵机。
限值、增益和位置校正：会恢复为出厂值，之后同一位置可能对应不同角度。</translation>
    </message>
    <message>
        <source>The previous settings were saved to %1</source>
        <translation>之前的设置已保存到 %1</translation>
    </message>
    <message>
        <source>The baud rate of this servo is fixed.</source>
        <translation>该舵机的波特率是固定的。</translation>
    </message>
    <message>
        <source>The servo already uses this baud rate.</source>
        <translation>舵机当前已使用此波特率。</translation>
    </message>
    <message>
        <source>After this change, the servo will reply only at %1 baud. ServoDesk switches automatically; other programs must be set to the new baud rate.</source>
        <translation>此后舵机只以波特率 %1 应答。ServoDesk 会自动切换；其他程序需要另行设置。</translation>
    </message>
    <message numerus="yes">
        <source>%n other servo(s) stay at %1 baud. A program that uses only one baud rate can no longer reach all servos.</source>
        <translation>
            <numerusform>另有 %n 个舵机仍使用波特率 %1。只用一个波特率的程序将无法访问全部舵机。</numerusform>
        </translation>
    </message>
    <message>
        <source>The new baud rate is tested first and written only if this adapter supports it. The servo keeps the new baud rate after power-off.</source>
        <translation>会先测试新波特率，仅当此适配器支持时才写入。断电后舵机仍保留新波特率。</translation>
    </message>
    <message>
        <source>Writes the baud rate, finds the servo at the new baud rate, and locks the EPROM</source>
        <translation>写入波特率，在新波特率下找到舵机，并给 EPROM 上锁</translation>
    </message>
    <message>
        <source>Baud rates supported by this family</source>
        <translation>该系列支持的波特率</translation>
    </message>
    <message>
        <source>The servo already has this ID.</source>
        <translation>舵机当前已使用此 ID。</translation>
    </message>
    <message>
        <source>ID %1 belongs to another servo (%2). Two servos with the same ID reply at the same time, so neither reply can be read.</source>
        <translation>ID %1 属于另一个舵机（%2）。两个舵机使用同一 ID 时会同时应答，两个应答都无法识别。</translation>
    </message>
    <message>
        <source>ServoDesk first checks ID %1 and writes it only if no servo replies with this ID.</source>
        <translation>会先查询 ID %1，没有舵机应答时才写入。</translation>
    </message>
    <message>
        <source>The servo uses the new ID immediately and keeps it after power-off. ServoDesk switches automatically; other programs must be set to the new ID.</source>
        <translation>舵机立即使用新 ID，断电后仍保留。ServoDesk 会自动切换；其他程序需要另行设置。</translation>
    </message>
    <message>
        <source>Checks that the new ID is free, writes it, and locks the EPROM using the new ID</source>
        <translation>确认新 ID 空闲，写入新 ID，并以新 ID 给 EPROM 上锁</translation>
    </message>
    <message>
        <source>Used and free IDs; select a free one</source>
        <translation>已用和空闲的 ID；请选择空闲的 ID</translation>
    </message>
    <message>
        <source>Stops as soon as the current step has been safely completed</source>
        <translation>当前步骤安全完成后立即停止</translation>
    </message>
    <message>
        <source>Closes this dialog; the operation in progress continues</source>
        <translation>关闭此对话框；正在进行的操作会继续到结束</translation>
    </message>
    <message>
        <source>Position correction</source>
        <translation>位置校正</translation>
    </message>
    <message>
        <source>blink LED</source>
        <translation>闪烁 LED</translation>
    </message>
    <message>
        <source>some old and some new values</source>
        <translation>部分新值，部分原值</translation>
    </message>
    <message>
        <source>no reply</source>
        <translation>没有应答</translation>
    </message>
    <message>
        <source>replies cannot be decoded</source>
        <translation>应答无法解析</translation>
    </message>
    <message>
        <source>still in progress in another program</source>
        <translation>仍在另一个程序中进行</translation>
    </message>
    <message>
        <source>value has changed in the meantime; left as is</source>
        <translation>数值后来又有变动，保持不变</translation>
    </message>
    <message>
        <source>reset to factory defaults</source>
        <translation>恢复出厂设置</translation>
    </message>
    <message>
        <source>Remedy: %1</source>
        <translation>处理方法：%1</translation>
    </message>
    <message>
        <source>The servo replies as ID %1.</source>
        <translation>舵机现以 ID %1 应答。</translation>
    </message>
    <message>
        <source>The servo did not reply at the end of the operation, so its baud rate may be %1 or %2. To find the servo, use Port → Interrupted writes or search at both baud rates.</source>
        <translation>操作结束时舵机没有应答，因此其波特率可能是 %1 或 %2。要找到该舵机，请使用“端口 → 未写完的更改”，或以这两个波特率搜索。</translation>
    </message>
    <message>
        <source>The servo did not reply at the end of the operation, so its ID may be %1 or %2. To find the servo, use Port → Interrupted writes or search the bus.</source>
        <translation>操作结束时舵机没有应答，因此其 ID 可能是 %1 或 %2。要找到该舵机，请使用“端口 → 未写完的更改”，或搜索总线。</translation>
    </message>
    <message>
        <source>Some steps did not end as expected.</source>
        <translation>并非所有步骤都按预期完成。</translation>
    </message>
    <message>
        <source>Select the firmware file</source>
        <translation>选择固件文件</translation>
    </message>
    <message>
        <source>Firmware for bus servos (*.bin)</source>
        <translation>总线舵机固件 (*.bin)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>No file selected.</source>
        <translation>尚未选择文件。</translation>
    </message>
    <message>
        <source>Select file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>Selects the vendor&apos;s firmware file, *.bin</source>
        <translation>选择厂家的固件文件，*.bin</translation>
    </message>
    <message>
        <source>The old settings are saved; the Snapshots page restores them.</source>
        <translation>原来的设置已保存，可在“快照”页恢复。</translation>
    </message>
    <message>
        <source>ID %1, firmware %2</source>
        <translation>ID %1，固件 %2</translation>
    </message>
    <message>
        <source>%1 of %2 blocks were accepted.</source>
        <translation>舵机接受了 %2 个数据块中的 %1 个。</translation>
    </message>
    <message>
        <source>Rescue firmware</source>
        <translation>救援固件</translation>
    </message>
    <message>
        <source>For a servo that no longer replies after an interrupted update. Connect only this servo: every servo whose supply comes on meanwhile receives the firmware. Turn the servo&apos;s supply off, press Start, then turn it on within 30 seconds.</source>
        <translation>用于更新中断后不再应答的舵机。只连接这个舵机：在此期间接通电源的每个舵机都会收到固件。请断开舵机电源，按“开始”，然后在 30 秒内接通电源。</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Waits for the servo&apos;s bootloader, then sends the firmware</source>
        <translation>等待舵机的引导程序，然后发送固件</translation>
    </message>
    <message>
        <source>Update firmware</source>
        <translation>更新固件</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>更新</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Sends the firmware to the servo</source>
        <translation>把固件发送到舵机</translation>
    </message>
    <message>
        <source>Checks the servo, its supply and the file</source>
        <translation>检查舵机、电源和文件</translation>
    </message>
    <message>
        <source>I accept this risk</source>
        <translation>我接受此风险</translation>
    </message>
    <message>
        <source>Accept: %1</source>
        <translation>接受：%1</translation>
    </message>
    <message>
        <source>Lets the update start although this check has failed</source>
        <translation>即使此项检查未通过，也允许开始更新</translation>
    </message>
    <message>
        <source>The servo, its supply and the file are checked first. Torque is turned on at the present position for a moment, then off, so a load held by the servo will drop.

The first block erases the old firmware. Until the whole file has been sent, keep the supply on and the cable plugged in; Stop has no effect then.</source>
        <translation>首先检查舵机、电源和文件。检查时会在当前位置短暂打开扭矩，然后卸力，因此舵机支撑的负载会落下。

第一个数据块会擦除原来的固件。在文件全部发送完之前，请保持供电并且不要拔线；此时“停止”不起作用。</translation>
    </message>
    <message>
        <source>Servo %1: %2</source>
        <translation>舵机 %1：%2</translation>
    </message>
    <message>
        <source>Not updated yet: ID %1</source>
        <translation>尚未更新：ID %1</translation>
    </message>
    <message>
        <source>Turn the servo&apos;s supply on now (%1 left).</source>
        <translation>请现在接通舵机电源（剩余 %1）。</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1（第 %2 个，共 %3 个）</translation>
    </message>
    <message numerus="yes">
        <source>%n servo(s) run the new firmware.</source>
        <translation>
            <numerusform>%n 个舵机已运行新固件。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n servo(s), one after the other: ID %1</source>
        <translation>
            <numerusform>依次更新 %n 个舵机：ID %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Closes this dialog; the present servo is completed, those after it are not updated</source>
        <translation>关闭此对话框；当前舵机会完成，其后的舵机不再更新</translation>
    </message>
</context>
<context>
    <name>SnapshotReport</name>
    <message>
        <source>Baud rate</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>模板</translation>
    </message>
    <message>
        <source>Servo snapshot</source>
        <translation>舵机快照</translation>
    </message>
    <message>
        <source>SIMULATED: not a real servo</source>
        <translation>模拟：不是真实舵机</translation>
    </message>
</context>
<context>
    <name>SnapshotRow</name>
    <message>
        <source>before a change</source>
        <translation>修改之前</translation>
    </message>
    <message>
        <source>manual</source>
        <translation>手动保存</translation>
    </message>
    <message>
        <source>bundle</source>
        <translation>整组快照</translation>
    </message>
    <message>
        <source>before commissioning</source>
        <translation>批量设置前</translation>
    </message>
    <message>
        <source>firmware %1, port %2</source>
        <translation>固件 %1，端口 %2</translation>
    </message>
    <message numerus="yes">
        <source>%n servo(s)</source>
        <translation>
            <numerusform>%n 个舵机</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>template, %n row(s)</source>
        <translation>
            <numerusform>模板，%n 行</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StepText</name>
    <message>
        <source>Time since goal was sent, ms</source>
        <translation>发出目标后的时间（ms）</translation>
    </message>
    <message>
        <source>Movement toward goal, steps</source>
        <translation>朝目标方向的位移（步）</translation>
    </message>
    <message>
        <source>Step responses</source>
        <translation>阶跃响应</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>After</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>变化</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>阶跃响应</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Values are means of all responses in both directions; steady-state errors are absolute values.</source>
        <translation>各数值为所有往返响应的平均值；静差取绝对值。</translation>
    </message>
    <message>
        <source>What to try next</source>
        <translation>下一步建议</translation>
    </message>
    <message>
        <source>Dead time</source>
        <translation>延迟时间</translation>
    </message>
    <message>
        <source>Rise time 10–90 %</source>
        <translation>上升时间 10–90%</translation>
    </message>
    <message>
        <source>Time to goal</source>
        <translation>到位时间</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>整定时间</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>Steady-state error</source>
        <translation>静差</translation>
    </message>
    <message>
        <source>Oscillations after arrival</source>
        <translation>到位后振荡次数</translation>
    </message>
    <message>
        <source>Oscillation frequency</source>
        <translation>振荡频率</translation>
    </message>
    <message>
        <source>Oscillation amplitude</source>
        <translation>振荡幅度</translation>
    </message>
    <message>
        <source>Peak speed</source>
        <translation>峰值速度</translation>
    </message>
    <message>
        <source>Peak current</source>
        <translation>峰值电流</translation>
    </message>
    <message>
        <source>Peak load</source>
        <translation>峰值负载</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <comment>in steps</comment>
        <translation>超调步数</translation>
    </message>
    <message>
        <source>better</source>
        <translation>变好</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>变差</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>Readings were lost while the servo was moving, so the times and speeds of the affected responses are unknown.</source>
        <translation>运动过程中有采样数据丢失，因此这些响应的时间和速度未知。</translation>
    </message>
    <message>
        <source>The servo did not move, so its gains cannot be judged.</source>
        <translation>舵机没有运动，因此无法评价其增益。</translation>
    </message>
    <message>
        <source>The servo stopped far from its goal because its movement is blocked, so its gains cannot be judged.</source>
        <translation>舵机停在远离目标处，说明运动受阻，因此无法评价其增益。</translation>
    </message>
    <message>
        <source>The servo lags behind: P is too low.</source>
        <translation>跟随滞后：P 偏小。</translation>
    </message>
    <message>
        <source>The servo moved as fast as its settings allow: speed or acceleration is limited.</source>
        <translation>运动已达到设定上限：速度或加速度受限。</translation>
    </message>
    <message>
        <source>The servo overshoots: D is too low.</source>
        <translation>超调：D 偏小。</translation>
    </message>
    <message>
        <source>The servo stops short of its goal: I is too low to overcome static friction. Gear backlash cannot be tuned out.</source>
        <translation>停在目标附近，存在静差：I 偏小，不足以克服静摩擦。齿轮间隙无法通过调整增益消除。</translation>
    </message>
    <message>
        <source>The servo jitters: D or the startup force is too high, I is above 0, the dead zone is too small, or the mechanism has backlash.</source>
        <translation>抖动：I 不为 0、D 或启动力过大、死区过小，或机构有间隙。</translation>
    </message>
    <message>
        <source>The servo oscillates strongly: P is far too high.</source>
        <translation>强烈振荡：P 过大。</translation>
    </message>
    <message>
        <source>Check the cable, adapter and CPU load, then run the test again</source>
        <translation>检查线缆、适配器和电脑 CPU 占用，然后重新运行测试</translation>
    </message>
    <message>
        <source>Check the mechanism, end stops, torque limit and power supply</source>
        <translation>检查机构、机械限位、扭矩限制和供电</translation>
    </message>
    <message>
        <source>Check the power supply, torque limit, alarms and mechanism, or use a larger step</source>
        <translation>检查供电、扭矩限制、报警和机构，或加大阶跃幅度</translation>
    </message>
    <message>
        <source>Raise P</source>
        <translation>加大 P</translation>
    </message>
    <message>
        <source>Lower P</source>
        <translation>减小 P</translation>
    </message>
    <message>
        <source>Raise D</source>
        <translation>加大 D</translation>
    </message>
    <message>
        <source>Lower D</source>
        <translation>减小 D</translation>
    </message>
    <message>
        <source>Raise I in small steps until the error is small enough</source>
        <translation>小幅逐步加大 I，直到静差足够小</translation>
    </message>
    <message>
        <source>Set I to 0</source>
        <translation>将 I 设为 0</translation>
    </message>
    <message>
        <source>Lower the startup force</source>
        <translation>减小启动力</translation>
    </message>
    <message>
        <source>Increase the dead zone</source>
        <translation>加大死区</translation>
    </message>
    <message>
        <source>Reduce the dead zone</source>
        <translation>减小死区</translation>
    </message>
    <message>
        <source>Allow a higher speed</source>
        <translation>提高速度上限</translation>
    </message>
    <message>
        <source>Allow a higher acceleration</source>
        <translation>提高加速度上限</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>无明显变化</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1：%2 %3</translation>
    </message>
</context>
<context>
    <name>SweepCompareText</name>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Comparison of two sweep tests</source>
        <translation>两次扫描测试对比</translation>
    </message>
    <message>
        <source>Test run</source>
        <translation>测试记录</translation>
    </message>
    <message>
        <source>Better</source>
        <translation>更优</translation>
    </message>
    <message>
        <source>Grade, test A</source>
        <translation>测试 A 的判定</translation>
    </message>
    <message>
        <source>Grade, test B</source>
        <translation>测试 B 的判定</translation>
    </message>
    <message>
        <source>Differences between the tests</source>
        <translation>测试之间的差异</translation>
    </message>
    <message>
        <source>The tests used different movements, so the metrics cannot be compared.</source>
        <translation>两次测试的运动方式不同，指标不可对比。</translation>
    </message>
    <message>
        <source>Some metrics depend on the differences below.</source>
        <translation>部分指标受下列差异影响。</translation>
    </message>
    <message>
        <source>The limits differ: the metrics can be compared, but the grades cannot.</source>
        <translation>限值不同：指标可以对比，判定不可对比。</translation>
    </message>
    <message>
        <source>Both tests used the same settings.</source>
        <translation>两次测试的设置相同。</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Different settings</source>
        <translation>不同的参数</translation>
    </message>
    <message>
        <source>All settings are the same.</source>
        <translation>参数全部相同。</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Distribution of steady-state error</source>
        <translation>各行程静差分布</translation>
    </message>
    <message>
        <source>Steps per turn</source>
        <translation>每圈步数</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>Range, steps</source>
        <translation>范围（步）</translation>
    </message>
    <message>
        <source>Step size, steps</source>
        <translation>步长（步）</translation>
    </message>
    <message>
        <source>Period, ms</source>
        <translation>周期（ms）</translation>
    </message>
    <message>
        <source>Dwell or delay, ms</source>
        <translation>停留或延时（ms）</translation>
    </message>
    <message>
        <source>Speed, step/s</source>
        <translation>速度（步/s）</translation>
    </message>
    <message>
        <source>Acceleration, step/s²</source>
        <translation>加速度（步/s²）</translation>
    </message>
    <message>
        <source>Warm-up, ms</source>
        <translation>预热（ms）</translation>
    </message>
    <message>
        <source>%1 %2 %3 (%4)</source>
        <comment>figure, number, unit</comment>
        <translation>%1 %2 %3（%4）</translation>
    </message>
    <message>
        <source>better</source>
        <translation>更优</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>更差</translation>
    </message>
</context>
<context>
    <name>SweepText</name>
    <message>
        <source>Sweep test report</source>
        <translation>扫描测试报告</translation>
    </message>
    <message>
        <source>SIMULATED: no real servo was tested</source>
        <translation>模拟：未测试真实舵机</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>工位</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试内容</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作员</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>运行时长</translation>
    </message>
    <message>
        <source>Reading rate per servo</source>
        <translation>每个舵机的采样率</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>End</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Ended by servo</source>
        <translation>导致结束的舵机</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>协议</translation>
    </message>
    <message>
        <source>Movement pattern</source>
        <translation>运动方式</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>Step size</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>周期</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Goals</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Next goal</source>
        <translation>下一目标</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>循环次数</translation>
    </message>
    <message>
        <source>unlimited</source>
        <translation>不限</translation>
    </message>
    <message>
        <source>Maximum duration</source>
        <translation>最长时间</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Travel time, ms</source>
        <translation>运行时间（ms）</translation>
    </message>
    <message>
        <source>the servo&apos;s present setting</source>
        <translation>舵机当前设置</translation>
    </message>
    <message>
        <source>Warm-up (not measured)</source>
        <translation>预热（不计入测量）</translation>
    </message>
    <message>
        <source>After the test</source>
        <translation>测试结束后</translation>
    </message>
    <message>
        <source>hold position</source>
        <translation>保持位置</translation>
    </message>
    <message>
        <source>torque off</source>
        <translation>卸力</translation>
    </message>
    <message>
        <source>End early after</source>
        <translation>提前结束条件</translation>
    </message>
    <message>
        <source>an alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>a stall</source>
        <translation>堵转</translation>
    </message>
    <message>
        <source>the first failure</source>
        <translation>首个不合格项</translation>
    </message>
    <message>
        <source>only a lost connection</source>
        <translation>仅连接断开</translation>
    </message>
    <message>
        <source>Range in steps</source>
        <translation>范围（步）</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>到位允差</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Warn at</source>
        <translation>警告限值</translation>
    </message>
    <message>
        <source>Fail at</source>
        <translation>不合格限值</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>within the limits</source>
        <translation>在限值之内</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>高于 %1</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>低于 %1</translation>
    </message>
    <message>
        <source>not measured: the servo does not report this value, or no move was suitable</source>
        <translation>未测量：舵机没有此项反馈，或没有合适的行程</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>样本数</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>Errors, overshoot, settling time, phase lag, repeatability, current and load are judged by the worst move. Speeds and the time to goal are judged by their means; counts are judged by their sums.</source>
        <translation>判定依据：各项误差、超调、整定时间、相位滞后、重复性、电流和负载取最差行程的值；速度和到位时间取平均值；计数项取总和。</translation>
    </message>
    <message>
        <source>Positions are as reported by the servo; gear backlash beyond the encoder is not measured.</source>
        <translation>位置均为舵机反馈的数值，不包含编码器之后的齿轮间隙。</translation>
    </message>
    <message>
        <source>Position and goal</source>
        <translation>位置与目标</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>时间（s）</translation>
    </message>
    <message>
        <source>Position, steps</source>
        <translation>位置（步）</translation>
    </message>
    <message>
        <source>Distribution of steady-state error</source>
        <translation>各行程静差分布</translation>
    </message>
    <message>
        <source>Steady-state error, steps</source>
        <translation>静差（步）</translation>
    </message>
    <message>
        <source>Moves</source>
        <comment>number</comment>
        <translation>行程数</translation>
    </message>
    <message>
        <source>No chart is available because no readings were stored.</source>
        <translation>没有可绘图的采样数据。</translation>
    </message>
    <message>
        <source>Steady-state error was not measured.</source>
        <translation>静差未测量。</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>各行程数据</translation>
    </message>
    <message>
        <source>The first 50, the last 50, and the worst 20 of the remaining moves are shown (%1 moves in total). The CSV and JSON files contain all moves.</source>
        <translation>共 %1 个行程，此处列出前 50 个、后 50 个及其余中最差的 20 个；CSV 和 JSON 文件包含全部行程。</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>行程</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>循环</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Position reached</source>
        <translation>到达位置</translation>
    </message>
    <message>
        <source>Time to goal, ms</source>
        <translation>到位时间（ms）</translation>
    </message>
    <message>
        <source>Settling, ms</source>
        <translation>整定时间（ms）</translation>
    </message>
    <message>
        <source>Overshoot, %</source>
        <translation>超调（%）</translation>
    </message>
    <message>
        <source>Error, steps</source>
        <translation>静差（步）</translation>
    </message>
    <message>
        <source>Mean speed, step/s</source>
        <translation>平均速度（步/s）</translation>
    </message>
    <message>
        <source>Following error, steps</source>
        <translation>跟随误差（步）</translation>
    </message>
    <message>
        <source>Peak current, mA</source>
        <translation>峰值电流（mA）</translation>
    </message>
    <message>
        <source>Peak load, %</source>
        <translation>峰值负载（%）</translation>
    </message>
    <message>
        <source>Min voltage, V</source>
        <translation>最低电压（V）</translation>
    </message>
    <message>
        <source>Temp., °C</source>
        <translation>温度（°C）</translation>
    </message>
    <message>
        <source>Lost readings</source>
        <translation>丢失采样数</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>goal missed</source>
        <translation>未到位</translation>
    </message>
    <message>
        <source>moving flag error</source>
        <translation>移动标志错误</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>总线</translation>
    </message>
    <message>
        <source>Reads and writes</source>
        <translation>读写次数</translation>
    </message>
    <message>
        <source>No reply</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>Wrong checksum</source>
        <translation>校验错误</translation>
    </message>
    <message>
        <source>Unexpected packets</source>
        <translation>非预期数据包</translation>
    </message>
    <message>
        <source>Late replies</source>
        <translation>迟到应答</translation>
    </message>
    <message>
        <source>Interruptions</source>
        <translation>中断</translation>
    </message>
    <message>
        <source>Duration, s</source>
        <translation>持续时间（s）</translation>
    </message>
    <message>
        <source>The connection was never interrupted.</source>
        <translation>连接从未中断。</translation>
    </message>
    <message>
        <source>Memory table at the start</source>
        <translation>开始时的内存表</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Raw value</source>
        <translation>原始值</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>存储区</translation>
    </message>
    <message>
        <source>Read at</source>
        <translation>读取时间</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Time to goal</source>
        <translation>到位时间</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>整定时间</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>Steady-state error</source>
        <translation>静差</translation>
    </message>
    <message>
        <source>Hysteresis, both directions</source>
        <translation>回差（双向）</translation>
    </message>
    <message>
        <source>Repeatability σ</source>
        <translation>重复性 σ</translation>
    </message>
    <message>
        <source>Repeatability range</source>
        <translation>重复性极差</translation>
    </message>
    <message>
        <source>Following error</source>
        <translation>跟随误差</translation>
    </message>
    <message>
        <source>Relative following error</source>
        <translation>相对跟随误差</translation>
    </message>
    <message>
        <source>Phase lag</source>
        <translation>相位滞后</translation>
    </message>
    <message>
        <source>Readings per period</source>
        <translation>每周期采样数</translation>
    </message>
    <message>
        <source>Mean speed</source>
        <translation>平均速度</translation>
    </message>
    <message>
        <source>Top speed</source>
        <translation>最高速度</translation>
    </message>
    <message>
        <source>Peak current</source>
        <translation>峰值电流</translation>
    </message>
    <message>
        <source>Mean current</source>
        <translation>平均电流</translation>
    </message>
    <message>
        <source>Peak load</source>
        <translation>峰值负载</translation>
    </message>
    <message>
        <source>Mean load</source>
        <translation>平均负载</translation>
    </message>
    <message>
        <source>Lowest voltage</source>
        <translation>最低电压</translation>
    </message>
    <message>
        <source>Temperature rise</source>
        <translation>温升</translation>
    </message>
    <message>
        <source>Highest temperature</source>
        <translation>最高温度</translation>
    </message>
    <message>
        <source>Moving flag errors</source>
        <translation>移动标志错误</translation>
    </message>
    <message>
        <source>Missed goals</source>
        <translation>未到位次数</translation>
    </message>
    <message>
        <source>Communication errors</source>
        <translation>通信错误</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>step</source>
        <translation>步</translation>
    </message>
    <message>
        <source>step/s</source>
        <translation>步/s</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>个行程</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>过压欠压</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>过温</translation>
    </message>
    <message>
        <source>overcurrent</source>
        <translation>过流</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>overload</source>
        <translation>过载</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>Warn</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>No verdict</source>
        <translation>无结论</translation>
    </message>
    <message>
        <source>The test ended too early.</source>
        <translation>测试结束过早。</translation>
    </message>
    <message>
        <source>The test was too short to judge. Run at least one whole cycle.</source>
        <translation>测试太短，无法判定。请至少运行一个完整循环。</translation>
    </message>
    <message>
        <source>There were fewer than 20 readings per period. Use a longer period, fewer servos or a higher baud rate.</source>
        <translation>每周期采样数少于 20。请加长周期、减少舵机或提高波特率。</translation>
    </message>
    <message>
        <source>The sine motion is faster than the speed set for the servo. Use a longer period, a smaller range or a higher speed.</source>
        <translation>正弦运动所需的速度高于舵机的设定速度。请加长周期、缩小范围或提高速度。</translation>
    </message>
    <message>
        <source>No limits are set for how closely the servo follows its goal. Add limits for the relative following error and the phase lag.</source>
        <translation>没有设定跟随误差方面的限值。请添加相对跟随误差和相位滞后的限值。</translation>
    </message>
    <message>
        <source>The moves are too short for the tolerance, so even a servo that does not move would pass. Make each move at least three times as long as the tolerance.</source>
        <translation>相对于到位允差，行程太短，静止不动的舵机也会合格。行程至少应为允差的三倍。</translation>
    </message>
    <message>
        <source>The servo lags too far behind, but the communication delay may be the cause. At least 40 readings per period are needed: use a longer period, fewer servos or a faster adapter.</source>
        <translation>滞后超出限值，但可能是通信延迟所致。每周期至少需采样 40 次：请加长周期、减少舵机数量或换用更快的适配器。</translation>
    </message>
    <message>
        <source>The metrics needed for a verdict were not measured in most moves. Allow more time for each move, or read faster: use fewer servos or a faster adapter.</source>
        <translation>大多数行程未测得判定本测试所需的指标。请延长每次运动的时间，或加快读取：减少舵机数量或换用更快的适配器。</translation>
    </message>
    <message>
        <source>Completed.</source>
        <translation>已完成。</translation>
    </message>
    <message>
        <source>Stopped by the user.</source>
        <translation>用户提前停止了测试。</translation>
    </message>
    <message>
        <source>Ended by the emergency stop; torque was turned off on the whole bus.</source>
        <translation>因急停而结束：总线上所有舵机已卸力。</translation>
    </message>
    <message>
        <source>Ended early: a servo raised an alarm.</source>
        <translation>提前结束：舵机报警。</translation>
    </message>
    <message>
        <source>Ended early: a servo stalled before reaching its goal.</source>
        <translation>提前结束：舵机未到达目标就已堵转。</translation>
    </message>
    <message>
        <source>Ended early: a limit was violated, and the test was set to stop at the first failure.</source>
        <translation>提前结束：出现不合格项，按设置停止。</translation>
    </message>
    <message>
        <source>Ended early: a servo no longer accepted its goal because its limits or mode changed.</source>
        <translation>提前结束：舵机的限值或运行模式已改变，因此不再接受目标位置。</translation>
    </message>
    <message>
        <source>Ended early: a servo lost torque because it rebooted or another program turned torque off. Torque was not turned on again.</source>
        <translation>提前结束：舵机失去扭矩（舵机已重启，或其他程序使其卸力）。之后未再打开扭矩。</translation>
    </message>
    <message>
        <source>Ended early: a different servo is now replying with the ID of the tested servo.</source>
        <translation>提前结束：现在以被测舵机的 ID 应答的是另一个舵机。</translation>
    </message>
    <message>
        <source>Ended early: the connection was lost and was not restored.</source>
        <translation>提前结束：连接断开且未恢复。</translation>
    </message>
    <message>
        <source>back and forth</source>
        <translation>来回扫描</translation>
    </message>
    <message>
        <source>staircase up and down</source>
        <translation>阶梯来回</translation>
    </message>
    <message>
        <source>middle of the range from both directions</source>
        <translation>双向到达行程范围中间</translation>
    </message>
    <message>
        <source>random goals</source>
        <translation>随机目标</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>正弦</translation>
    </message>
    <message>
        <source>list of goals</source>
        <translation>目标列表</translation>
    </message>
    <message>
        <source>delay from one goal to the next, whether or not the goal is reached</source>
        <translation>延时（从一个目标到下一个，不论是否到位）</translation>
    </message>
    <message>
        <source>dwell after arrival</source>
        <translation>到位后停留</translation>
    </message>
    <message>
        <source>bit %1</source>
        <translation>位 %1</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Only the worst %1 of %2 moves are shown. The HTML report shows more; the CSV and JSON files contain all moves.</source>
        <translation>只列出 %2 个行程中最差的 %1 个。HTML 报告列出的行程更多，CSV 和 JSON 文件包含全部行程。</translation>
    </message>
    <message>
        <source>The HTML report also contains the memory tables and more details about each move.</source>
        <translation>HTML 报告还包含内存表和每个行程的更多数据。</translation>
    </message>
    <message>
        <source>Any servo, built in</source>
        <translation>任何舵机（内置）</translation>
    </message>
    <message>
        <source>4096 steps a turn, built in</source>
        <translation>每圈 4096 步（内置）</translation>
    </message>
    <message>
        <source>SCS, 1024 steps, built in</source>
        <translation>SCS，1024 步（内置）</translation>
    </message>
    <message>
        <source>LX, 1000 steps, built in</source>
        <translation>LX，1000 步（内置）</translation>
    </message>
    <message>
        <source>%1, custom</source>
        <translation>%1（自定）</translation>
    </message>
</context>
<context>
    <name>Trend</name>
    <message>
        <source>Goal</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Error (goal − position)</source>
        <translation>误差（目标 − 位置）</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>负载</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>电压</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Moving flag</source>
        <translation>移动标志</translation>
    </message>
    <message>
        <source>ID %1 · %2</source>
        <translation>ID %1 · %2</translation>
    </message>
    <message>
        <source>replies again</source>
        <translation>恢复应答</translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>%1 (derived)</source>
        <translation>%1（推算）</translation>
    </message>
    <message>
        <source>cleared: %1</source>
        <translation>已解除：%1</translation>
    </message>
    <message>
        <source>no reply</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>%1 off scale %2 · Fit</source>
        <translation>%1 超出显示范围 %2 · 自动调整</translation>
    </message>
</context>
<context>
    <name>UndoText</name>
    <message>
        <source>ID %1 · %2</source>
        <translation>ID %1 · %2</translation>
    </message>
    <message>
        <source>ID %1 · %2: %3 → %4</source>
        <translation>ID %1 · %2：%3 → %4</translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s)</source>
        <translation>
            <numerusform>%n 项设置</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ValueEditor</name>
    <message>
        <source>“%1” is below the resolution of this register and would become 0.</source>
        <translation>“%1”小于该参数的分辨率，会变成 0。</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>没有写入任何内容。</translation>
    </message>
    <message>
        <source>Select one of: %1.</source>
        <translation>请从中选择：%1。</translation>
    </message>
    <message>
        <source>Enter a whole number (%1).</source>
        <translation>请输入整数，范围 %1。</translation>
    </message>
    <message>
        <source>Enter a whole number (%1) or a value with its unit, such as %2.</source>
        <translation>请输入整数（范围 %1），或带单位的数值，例如 %2。</translation>
    </message>
    <message>
        <source>No value entered.</source>
        <translation>没有输入数值。</translation>
    </message>
    <message>
        <source>“%1” is not a valid value for this register.</source>
        <translation>“%1”不是该参数的有效数值。</translation>
    </message>
    <message>
        <source>%1 is not a documented value; the servo may react unpredictably.</source>
        <translation>%1 不是资料中列出的数值，舵机的反应无法预料。</translation>
    </message>
    <message>
        <source>%1 is outside the range of this register (%2).</source>
        <translation>%1 超出该参数的允许范围（%2）。</translation>
    </message>
</context>
<context>
    <name>WriteQuestion</name>
    <message>
        <source>The value is lost at power-off.</source>
        <translation>该值断电后丢失。</translation>
    </message>
    <message>
        <source>Change the mode to “%1”?</source>
        <translation>切换到“%1”模式？</translation>
    </message>
    <message>
        <source>Write %1?</source>
        <translation>写入 %1？</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>In this mode, the shaft turns continuously as soon as the servo receives a command. Clear the area around the mechanism first.</source>
        <translation>在该模式下，舵机一收到指令，输出轴就会持续转动。请先确保机构周围无人、无障碍物。</translation>
    </message>
    <message>
        <source>In this mode, the shaft is not restricted by angle limits. Clear the area around the mechanism first.</source>
        <translation>在该模式下，输出轴不受角度限制。请先确保机构周围无人、无障碍物。</translation>
    </message>
    <message>
        <source>Writing %1 to %2 switches the servo from “%3” to “%4”.</source>
        <translation>向 %2 写入 %1 会使舵机从“%3”切换到“%4”。</translation>
    </message>
    <message>
        <source>Writing %1 to %2 switches the servo to “%3”.</source>
        <translation>向 %2 写入 %1 会使舵机切换到“%3”。</translation>
    </message>
    <message>
        <source>The command register (%1) of the new mode is set to 0.</source>
        <translation>新模式的指令参数（%1）会清零。</translation>
    </message>
    <message>
        <source>ServoDesk turns torque off, writes the value and reads it back.</source>
        <translation>ServoDesk 先卸力，再写入并回读。</translation>
    </message>
    <message>
        <source>Change mode</source>
        <translation>切换模式</translation>
    </message>
    <message>
        <source>After this, the servo replies as ID %1. Programs that use the old ID will no longer find it.</source>
        <translation>此后舵机以 ID %1 应答。使用原 ID 的程序将找不到该舵机。</translation>
    </message>
    <message>
        <source>The servo switches to another baud rate. ServoDesk switches automatically; other programs and servos keep the old baud rate.</source>
        <translation>舵机将切换到另一个波特率。ServoDesk 会自动切换；其他程序和舵机仍使用原波特率。</translation>
    </message>
    <message>
        <source>Programs that expect the previous reply behavior may report the servo as lost.</source>
        <translation>按原方式等待应答的程序可能认为舵机失联。</translation>
    </message>
    <message>
        <source>With protection turned off, the motor can burn out and the gears can break.</source>
        <translation>关闭保护后，电机可能烧毁，齿轮可能损坏。</translation>
    </message>
    <message>
        <source>This changes the direction, feedback and drive of the motor. A wrong value can make the motor run out of control.</source>
        <translation>电机的方向、反馈和驱动方式会改变。数值写错可能使电机失控。</translation>
    </message>
    <message>
        <source>Afterwards, every position corresponds to a different angle than before. Clear the area around the mechanism before turning torque on.</source>
        <translation>此后每个位置对应的角度都与之前不同。打开扭矩前请确保机构周围无人、无障碍物。</translation>
    </message>
    <message>
        <source>A wrong value can make the servo unreachable or dangerous. Note the old value before you continue.</source>
        <translation>数值写错可能导致舵机失联或造成危险。继续之前请记下原值。</translation>
    </message>
    <message>
        <source>Old value: %1. New value: %2.</source>
        <translation>原值：%1。新值：%2。</translation>
    </message>
    <message>
        <source>New value: %1. The present value could not be read.</source>
        <translation>新值：%1。当前值无法读取。</translation>
    </message>
    <message>
        <source>Torque is turned off first and stays off.</source>
        <translation>先卸力，并保持卸力。</translation>
    </message>
    <message>
        <source>The shaft turns as soon as the value is written. Keep clear of the mechanism.</source>
        <translation>写入后输出轴立即转动。请远离机构。</translation>
    </message>
    <message>
        <source>Torque stays off until you turn it on.</source>
        <translation>在您打开扭矩之前，舵机保持卸力。</translation>
    </message>
    <message>
        <source>The present position becomes the midpoint. Afterwards, every position corresponds to a different angle than before, in other programs too.</source>
        <translation>当前位置将成为中位。此后每个位置对应的角度都与之前不同，其他程序也受影响。</translation>
    </message>
    <message>
        <source>With both angle limits at 0, the shaft can turn without limit.</source>
        <translation>两个角度限制均为 0 时，输出轴的转动不受限制。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message numerus="yes">
        <source>Write %n setting(s) that need confirmation?</source>
        <translation>
            <numerusform>写入 %n 项需要确认的参数？</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cli</name>
    <message>
        <source>did you mean %1?</source>
        <translation>是否要输入 %1？</translation>
    </message>
    <message>
        <source>Servo %1</source>
        <translation>舵机 %1</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>After</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>EPROM lock: %1</source>
        <translation>EPROM 锁：%1</translation>
    </message>
    <message>
        <source>Servo %1 has rebooted.</source>
        <translation>舵机 %1 已重启。</translation>
    </message>
    <message>
        <source>Model known</source>
        <translation>型号已知</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>Protocol, bus type</source>
        <translation>协议、总线类型</translation>
    </message>
    <message>
        <source>Port, baud rate</source>
        <translation>端口、波特率</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>运行模式</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>扭矩开关</translation>
    </message>
    <message>
        <source>EPROM lock</source>
        <translation>EPROM 锁</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>电压</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>移动中</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>已写入</translation>
    </message>
    <message>
        <source>raw value, or value with its unit</source>
        <translation>原始值，或带单位的数值</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>说明</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>制造商</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>USB</source>
        <translation>USB</translation>
    </message>
    <message>
        <source>list the ports on this computer</source>
        <translation>列出本机的端口</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>含义</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>字节</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>发送</translation>
    </message>
    <message>
        <source>received</source>
        <translation>接收</translation>
    </message>
    <message>
        <source>Servo %1: %2</source>
        <translation>舵机 %1：%2</translation>
    </message>
    <message>
        <source>read the whole memory table</source>
        <translation>读取整张内存表</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>修改内容</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>The servo replies as ID %1 at %2 baud.</source>
        <translation>舵机以 ID %1、波特率 %2 应答。</translation>
    </message>
    <message>
        <source>No registers have changed.</source>
        <translation>没有参数发生改变。</translation>
    </message>
    <message>
        <source>Changed registers: %1</source>
        <translation>改变的参数：%1</translation>
    </message>
    <message>
        <source>Restoring</source>
        <translation>正在恢复</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>固件版本</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>正在搜索</translation>
    </message>
    <message>
        <source>search the bus without writing anything</source>
        <translation>搜索总线；不写入任何内容</translation>
    </message>
    <message>
        <source>baud rates to use for the search</source>
        <translation>搜索时使用的波特率</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>键名</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>原始值</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>存储区</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>读写</translation>
    </message>
    <message>
        <source>Servo %1: %2 (%3), firmware %4, read on port %5 at %6</source>
        <translation>舵机 %1：%2（%3），固件 %4，端口 %5，时间 %6</translation>
    </message>
    <message>
        <source>save all registers of a servo to a file</source>
        <translation>把舵机的全部参数保存到文件</translation>
    </message>
    <message>
        <source>show a saved file; no port is needed</source>
        <translation>显示已保存的文件；不需要端口</translation>
    </message>
    <message>
        <source>torque on</source>
        <translation>扭矩已打开</translation>
    </message>
    <message>
        <source>torque off</source>
        <translation>已卸力</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>阻尼</translation>
    </message>
    <message>
        <source>switch the operating mode; torque stays off afterwards</source>
        <translation>切换运行模式；切换后保持卸力</translation>
    </message>
    <message>
        <source>servo IDs: 1 2 3, 1-6 or 1,3</source>
        <translation>舵机 ID：1 2 3、1-6 或 1,3</translation>
    </message>
    <message>
        <source>write the readings to a file</source>
        <translation>把采样数据写入文件</translation>
    </message>
    <message>
        <source>change registers safely: record, unlock, write, read back, lock</source>
        <translation>安全修改参数：记录、解锁、写入、回读、上锁</translation>
    </message>
    <message>
        <source>Finds, reads, configures and drives serial bus servos.</source>
        <translation>搜索、读取、设置和驱动串行总线舵机。</translation>
    </message>
    <message>
        <source>Usage: servodesk-cli [OPTIONS] COMMAND …</source>
        <translation>用法：servodesk-cli [选项] 命令 …</translation>
    </message>
    <message>
        <source>Usage: servodesk-cli [OPTIONS] %1</source>
        <translation>用法：servodesk-cli [选项] %1</translation>
    </message>
    <message>
        <source>Options for this command:</source>
        <translation>此命令的选项：</translation>
    </message>
    <message>
        <source>Options:</source>
        <translation>选项：</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>缺少 %1</translation>
    </message>
    <message>
        <source>unknown command &quot;%1&quot;</source>
        <translation>未知命令“%1”</translation>
    </message>
    <message>
        <source>The result could not be written: %1</source>
        <translation>无法输出结果：%1</translation>
    </message>
    <message>
        <source>a raw value from %1 to %2</source>
        <translation>%1 到 %2 的原始值</translation>
    </message>
    <message>
        <source>a raw value</source>
        <translation>原始值</translation>
    </message>
    <message>
        <source>a value with its unit (%1)</source>
        <translation>带单位的数值（%1）</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>以下之一：%1</translation>
    </message>
    <message>
        <source>, or </source>
        <comment>between alternatives</comment>
        <translation>，或</translation>
    </message>
    <message>
        <source>%1 (%2), firmware %3</source>
        <translation>%1（%2），固件 %3</translation>
    </message>
    <message>
        <source>Old</source>
        <translation>原值</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新值</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>回读</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>  Likely cause: %1</source>
        <translation>  可能原因：%1</translation>
    </message>
    <message>
        <source>  Remedy: %1</source>
        <translation>  处理方法：%1</translation>
    </message>
    <message>
        <source>Warning: %1, %2: %3</source>
        <translation>警告：%1，%2：%3</translation>
    </message>
    <message>
        <source>Using the only adapter, %1.</source>
        <translation>使用唯一的适配器 %1。</translation>
    </message>
    <message>
        <source>SIMULATED bus %1</source>
        <translation>模拟总线 %1</translation>
    </message>
    <message>
        <source>all known baud rates were tried</source>
        <translation>已知的波特率都试过了</translation>
    </message>
    <message>
        <source>Servo %1: %2</source>
        <comment>notice</comment>
        <translation>舵机 %1：%2</translation>
    </message>
    <message>
        <source>Servo %1 has the same settings as before.</source>
        <translation>舵机 %1 的参数与演示前相同。</translation>
    </message>
    <message>
        <source>Servo %1 differs from its previous state in these registers: %2</source>
        <translation>舵机 %1 与演示前不同的参数：%2</translation>
    </message>
    <message>
        <source>Next: run &quot;servodesk-cli ports&quot; to list your adapters and &quot;servodesk-cli --port PORT scan&quot; to find your servos.</source>
        <translation>接下来：运行“servodesk-cli ports”列出适配器，运行“servodesk-cli --port 端口 scan”搜索您的舵机。</translation>
    </message>
    <message>
        <source>After power-off</source>
        <translation>断电之后</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>已丢失</translation>
    </message>
    <message>
        <source>Search the bus: send a PING to each of the 254 IDs; nothing is written</source>
        <translation>搜索总线：向 254 个 ID 逐个发送 PING；不写入任何内容</translation>
    </message>
    <message>
        <source>Memory table of servo %1, %2 (excerpt)</source>
        <translation>舵机 %1 的内存表，%2（部分）</translation>
    </message>
    <message>
        <source>No servo reports an alarm.</source>
        <translation>没有舵机报警。</translation>
    </message>
    <message>
        <source>Move servo %1 and watch it</source>
        <translation>转动舵机 %1 并观察</translation>
    </message>
    <message>
        <source>time[s]</source>
        <translation>时间[s]</translation>
    </message>
    <message>
        <source>alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>协议</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>, %1 at %2 baud, found: %3</source>
        <translation>，%1，波特率 %2，已找到 %3 个</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>The alarm has cleared.</source>
        <translation>报警已解除。</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Warn</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>Grade</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Sweep test</source>
        <translation>扫描测试</translation>
    </message>
    <message>
        <source>Verdict: %1</source>
        <translation>结论：%1</translation>
    </message>
    <message>
        <source>Report: %1, readings: %2</source>
        <translation>报告：%1，采样数据：%2</translation>
    </message>
    <message>
        <source>travel time in milliseconds (SCS, LX)</source>
        <translation>运行时间，毫秒（SCS、LX）</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>阶跃响应</translation>
    </message>
    <message>
        <source>Step response (trial)</source>
        <translation>阶跃响应（试用）</translation>
    </message>
    <message>
        <source>Report: %1</source>
        <translation>报告：%1</translation>
    </message>
    <message>
        <source>write a report of the test to a file</source>
        <translation>将测试报告写入文件</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>only servos of this model</source>
        <translation>仅限此型号的舵机</translation>
    </message>
    <message>
        <source>only servos with this ID</source>
        <translation>仅限此 ID 的舵机</translation>
    </message>
    <message>
        <source>no test run %1 in the history; &quot;sweep-runs&quot; lists all test runs</source>
        <translation>历史记录中没有测试记录 %1；“sweep-runs”可列出全部测试记录</translation>
    </message>
    <message>
        <source>%1 does not contain servo %2</source>
        <translation>%1 中没有舵机 %2</translation>
    </message>
    <message>
        <source>Connect the next servo (it will get ID %1).</source>
        <translation>请接上下一个舵机（将设为 ID %1）。</translation>
    </message>
    <message>
        <source>%1 set up, %2 failed, %3 set aside; %4 unfinished. Batch: %5</source>
        <translation>完成 %1，失败 %2，剔除 %3；未完成 %4。批次：%5</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>Last write</source>
        <translation>最近写入</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>快照</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>参数数量</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>before a change</source>
        <translation>修改之前</translation>
    </message>
    <message>
        <source>manual</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行数</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>工位</translation>
    </message>
    <message>
        <source>Last sent</source>
        <translation>上次发送</translation>
    </message>
    <message>
        <source>Writes</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>no history yet</source>
        <translation>还没有历史记录</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>time: 2026-11-22T10:30, 10:30, or how long ago, such as 90m, 2h, 3d, 1w</source>
        <translation>时间：2026-11-22T10:30、10:30，或距现在的时长，如 90m、2h、3d、1w</translation>
    </message>
    <message>
        <source>Label: %1</source>
        <translation>标签：%1</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>备注：%1</translation>
    </message>
    <message>
        <source>Factory default</source>
        <translation>出厂默认值</translation>
    </message>
    <message>
        <source>%1 different, %2 missing, %3 unknown, %4 identical, %5 read-only</source>
        <translation>不同 %1，缺少 %2，未知 %3，相同 %4，只读 %5</translation>
    </message>
    <message>
        <source>only entries for writes to this register</source>
        <translation>仅限对此参数的写入</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>已撤销</translation>
    </message>
    <message>
        <source>Nothing to write.</source>
        <translation>无需写入。</translation>
    </message>
    <message>
        <source>No changes were necessary.</source>
        <translation>无需写入任何内容。</translation>
    </message>
    <message>
        <source>Result: %1</source>
        <translation>结果：%1</translation>
    </message>
    <message>
        <source>! %1: %2</source>
        <translation>! %1：%2</translation>
    </message>
    <message>
        <source>! %1, not selected: %2</source>
        <translation>! %1（未选中）：%2</translation>
    </message>
    <message>
        <source>ignored: the test did not finish</source>
        <translation>已忽略：测试未完成</translation>
    </message>
    <message>
        <source>--step &quot;%1&quot;: specify a step greater than 0, raw (100) or with its unit (10deg); to reverse the direction, swap --from and --to</source>
        <translation>--step “%1”：请给出大于 0 的步长，可为原始值（100）或带单位的数值（10deg）；如果要反向运动，请对调 --from 和 --to</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;: specify a whole number from %3 to %4</source>
        <translation>%1 “%2”：请给出 %3 到 %4 的整数</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;: specify a number of seconds from %3 to %4</source>
        <translation>%1 “%2”：请给出 %3 到 %4 的秒数</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;: specify a value of 0 or more, raw or with its unit; the goals determine the direction</source>
        <translation>%1 “%2”：请给出不小于 0 的值，可为原始值或带单位的数值；方向由目标决定</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>The trial was not run.</source>
        <translation>未进行试用。</translation>
    </message>
    <message>
        <source>ignored: the servo failed</source>
        <translation>已忽略：舵机不合格</translation>
    </message>
    <message>
        <source>%1, firmware %2</source>
        <translation>%1，固件 %2</translation>
    </message>
    <message>
        <source>the old values</source>
        <translation>原值</translation>
    </message>
    <message>
        <source>the new values</source>
        <translation>新值</translation>
    </message>
    <message>
        <source>Torque-off command sent (ID %1). Confirming…</source>
        <translation>已发送卸力指令（ID %1），正在确认…</translation>
    </message>
    <message>
        <source>Confirming the stop (ID %1)…</source>
        <translation>正在确认舵机已停止运动（ID %1）…</translation>
    </message>
    <message>
        <source>Abandoned: change %1, servo %2 (%3, %4)</source>
        <translation>已放弃：更改 %1，舵机 %2（%3，%4）</translation>
    </message>
    <message>
        <source>The servo was not read, so each register may hold either its old or its new value.</source>
        <translation>未读取舵机，因此每个参数可能是原值，也可能是新值。</translation>
    </message>
    <message>
        <source>ID %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>save the settings of all servos on the bus to one file</source>
        <translation>把总线上所有舵机的参数保存到一个文件</translation>
    </message>
    <message>
        <source>output file, for example NAME.bundle.json; an existing file is replaced</source>
        <translation>输出文件，例如 NAME.bundle.json；已有文件会被覆盖</translation>
    </message>
    <message>
        <source>only these servos: 1, 1-6 or 1,3,5</source>
        <translation>仅限这些舵机：1、1-6 或 1,3,5</translation>
    </message>
    <message>
        <source>label saved in the file</source>
        <translation>保存在文件中的标签</translation>
    </message>
    <message>
        <source>note saved in the file</source>
        <translation>保存在文件中的备注</translation>
    </message>
    <message>
        <source>restore the servos saved in a bundle, matching them by ID</source>
        <translation>恢复整组快照中的各舵机，按 ID 对应</translation>
    </message>
    <message>
        <source>file created by &quot;bundle save&quot;</source>
        <translation>由 bundle save 生成的文件</translation>
    </message>
    <message>
        <source>also write to IDs that now belong to a servo of a different model</source>
        <translation>即使某个 ID 现在属于其他型号的舵机，也写入</translation>
    </message>
    <message>
        <source>specify exactly one baud rate</source>
        <translation>请只指定一个波特率</translation>
    </message>
    <message>
        <source>change the ID of a servo after checking that the new ID is free</source>
        <translation>修改舵机 ID（先确认新 ID 未被占用）</translation>
    </message>
    <message>
        <source>current ID</source>
        <translation>当前 ID</translation>
    </message>
    <message>
        <source>change the baud rate of a servo</source>
        <translation>修改舵机波特率</translation>
    </message>
    <message>
        <source>ID of the servo</source>
        <translation>舵机的 ID</translation>
    </message>
    <message>
        <source>new baud rate</source>
        <translation>新的波特率</translation>
    </message>
    <message>
        <source>set the present position as the midpoint</source>
        <translation>把当前位置设为中位</translation>
    </message>
    <message>
        <source>reboot a servo and wait for its reply</source>
        <translation>重启舵机并等待其应答</translation>
    </message>
    <message>
        <source>Nothing was written. Keep clear of the mechanism and run the command again with --move.</source>
        <translation>没有写入任何内容。请远离机构，再加 --move 重新执行命令。</translation>
    </message>
    <message>
        <source>show the cause of an alarm and clear it</source>
        <translation>显示报警的原因并解除报警</translation>
    </message>
    <message>
        <source>allow torque to be turned on and the servo to move slightly</source>
        <translation>允许舵机轻微转动，并允许打开扭矩</translation>
    </message>
    <message>
        <source>use either --first-id or --id-list, not both</source>
        <translation>--first-id 与 --id-list 只能选一个</translation>
    </message>
    <message>
        <source>specify the batch file with --batch FILE.csv</source>
        <translation>请用 --batch FILE.csv 指定批次文件</translation>
    </message>
    <message>
        <source>Nothing was done. Press Enter to continue, or type &quot;a&quot; and press Enter to set the servo aside.</source>
        <translation>没有执行任何操作。按回车继续；输入“a”再按回车则剔除该舵机。</translation>
    </message>
    <message>
        <source>Warning: %1.</source>
        <translation>警告：%1。</translation>
    </message>
    <message>
        <source>The %1 with ID %2 at %3 baud will be changed to ID %4.</source>
        <translation>%1（ID %2，波特率 %3）将设为 ID %4。</translation>
    </message>
    <message>
        <source>Setup of a servo of this model was not finished, and no IDs are left for other servos. If the connected servo is that one, type &quot;s&quot; and press Enter. To set the connected servo aside, type &quot;a&quot; and press Enter.</source>
        <translation>有一个同型号的舵机尚未设置完，且已没有 ID 可分配给其他舵机。如果现在接上的就是该舵机，请输入“s”再按回车；要剔除现在接上的舵机，请输入“a”再按回车。</translation>
    </message>
    <message>
        <source>Setup of a servo of this model was not finished; its assigned ID is %1. If the connected servo is that one, type &quot;s&quot; and press Enter; otherwise, the connected servo is set up as a new one.</source>
        <translation>有一个同型号的舵机尚未设置完，已分配 ID %1。如果现在接上的就是该舵机，请输入“s”再按回车；否则会把现在接上的舵机作为新舵机设置。</translation>
    </message>
    <message>
        <source>This batch contains an unfinished servo of the same model. Continue only if it is the one that is connected now.</source>
        <translation>此批次中有一个同型号的舵机尚未设置完。确认接上的就是该舵机后再继续。</translation>
    </message>
    <message>
        <source>Press Enter to continue, or type &quot;a&quot; and press Enter to set the servo aside.</source>
        <translation>按回车继续；输入“a”再按回车则剔除该舵机。</translation>
    </message>
    <message>
        <source>The servo was disconnected during setup. Connect it again (ID %1).</source>
        <translation>舵机在设置过程中断开。请重新接上（ID %1）。</translation>
    </message>
    <message>
        <source>No IDs are left. Waiting for a servo whose setup is not finished.</source>
        <translation>ID 已用完。正在等待尚未设置完的舵机接上。</translation>
    </message>
    <message>
        <source>Several servos are replying, so nothing is written. Disconnect all but one.</source>
        <translation>有多个舵机应答，因此不写入任何内容。请拔下其余舵机，只留一个。</translation>
    </message>
    <message>
        <source>Two servos are replying with ID %1, so nothing is written. Disconnect one of them.</source>
        <translation>两个舵机都以 ID %1 应答，因此不写入任何内容。请拔下其中一个。</translation>
    </message>
    <message>
        <source>A device is replying but cannot be identified.</source>
        <translation>有设备应答，但无法识别。</translation>
    </message>
    <message>
        <source>Unplug the servo.</source>
        <translation>请拔下舵机。</translation>
    </message>
    <message>
        <source>ID %1 is done. Unplug the servo.</source>
        <translation>ID %1 已完成，请拔下舵机。</translation>
    </message>
    <message>
        <source>Unfinished: %1 with assigned ID %2. Some of its settings may have been written. Connect the servo and run the same command again to finish its setup.</source>
        <translation>未设置完：%1，分配的 ID 为 %2。部分参数可能已写入。请接上该舵机并再次运行同一命令，以完成设置。</translation>
    </message>
    <message>
        <source>&quot;recover&quot; shows the unfinished changes.</source>
        <translation>“recover”可显示未写完的更改。</translation>
    </message>
    <message>
        <source>All IDs have been assigned.</source>
        <translation>ID 已全部分配。</translation>
    </message>
    <message>
        <source>set up servos one at a time: template, ID, baud rate</source>
        <translation>逐个接上并设置舵机：模板、ID、波特率</translation>
    </message>
    <message>
        <source>batch file; an existing batch is resumed</source>
        <translation>批次文件；如果批次已存在，则继续该批次</translation>
    </message>
    <message>
        <source>first ID to assign (default: 1)</source>
        <translation>起始 ID（默认：1）</translation>
    </message>
    <message>
        <source>IDs to assign, in this order: 4-9,12</source>
        <translation>要分配的 ID，按此顺序分配：4-9,12</translation>
    </message>
    <message>
        <source>stop when this many servos in the batch have been set up</source>
        <translation>批次中完成的舵机达到此数量后结束</translation>
    </message>
    <message>
        <source>baud rate to write (default: unchanged)</source>
        <translation>要写入的波特率（默认：保持不变）</translation>
    </message>
    <message>
        <source>snapshot or template to write</source>
        <translation>要写入的快照或模板</translation>
    </message>
    <message>
        <source>also write the dangerous registers of the template</source>
        <translation>也写入模板中的危险参数</translation>
    </message>
    <message>
        <source>set up each servo without asking; servos with an alarm or another problem are set aside</source>
        <translation>设置每个舵机时不再询问；有报警或其他问题的舵机会被剔除</translation>
    </message>
    <message>
        <source>label text, with placeholders: {model} {id} {rate} {baud} {firmware} {date} {was_id}</source>
        <translation>标签文字，可含占位符：{model} {id} {rate} {baud} {firmware} {date} {was_id}</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Cleared</source>
        <translation>解除时间</translation>
    </message>
    <message>
        <source>No matching entries in the history.</source>
        <translation>历史记录中没有符合条件的内容。</translation>
    </message>
    <message>
        <source>Servos have no serial number, so servos with the same model, firmware, ID and label are listed as one.</source>
        <translation>舵机没有序列号：型号、固件、ID 和标签都相同的舵机视为同一个。</translation>
    </message>
    <message>
        <source>--kind must be writes, snapshots, alarms, recordings, runs, servos or (on a server only) benches</source>
        <translation>--kind 必须是 writes、snapshots、alarms、recordings、runs 或 servos；查看服务器时还可用 benches</translation>
    </message>
    <message>
        <source>use either --csv or --export, not both</source>
        <translation>--csv 和 --export 只能选一个</translation>
    </message>
    <message>
        <source>kind of entries: writes (default), snapshots, alarms, recordings, runs, servos or (on a server only) benches</source>
        <translation>内容类型：writes（默认）、snapshots、alarms、recordings、runs、servos；查看服务器时还可用 benches</translation>
    </message>
    <message>
        <source>write all matching entries to a JSON file instead</source>
        <translation>改为把所有符合条件的内容写入 JSON 文件</translation>
    </message>
    <message>
        <source>list writes, snapshots, alarms, recordings and tests of servos; no port is needed</source>
        <translation>列出舵机的写入、快照、报警、录制和测试；不需要端口</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a valid entry number</source>
        <translation>“%1”不是有效的编号</translation>
    </message>
    <message>
        <source>%1, ID %2, %3, on %4 at %5 baud, by %6</source>
        <translation>%1，ID %2，%3，端口 %4，波特率 %5，程序 %6</translation>
    </message>
    <message>
        <source>The %1 replying as ID %2 is now servo #%3, &quot;%4&quot;</source>
        <translation>以 ID %2 应答的 %1 现在是舵机 #%3，“%4”</translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) saved to %1</source>
        <translation>
            <numerusform>已把 %n 个参数保存到 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>From snapshot %1 taken on %2; written since then: %3</source>
        <translation>来自快照 %1（%2）；此后写入：%3</translation>
    </message>
    <message>
        <source>Saved without a value because the new value was not recorded: %1</source>
        <translation>以下参数的新值没有记录，因此保存时不含值：%1</translation>
    </message>
    <message>
        <source>Temporary writes are not included; for these registers, the table contains the stored values: %1</source>
        <translation>不计入临时写入；内存表中以下参数为已保存的值：%1</translation>
    </message>
    <message>
        <source>The ID was changed to %1 on %2; writes made with the new ID are in the history of the servo with ID %1, not here</source>
        <translation>ID 已于 %2 改为 %1；改 ID 之后的写入记录在 ID 为 %1 的舵机的历史记录中，不在此处</translation>
    </message>
    <message>
        <source>show a write and everything written together with it</source>
        <translation>显示一次写入以及同时写入的全部内容</translation>
    </message>
    <message>
        <source>write number, as listed by &quot;history&quot;</source>
        <translation>写入编号，见“history”的输出</translation>
    </message>
    <message>
        <source>label a servo in the history (servos have no serial number)</source>
        <translation>给历史记录中的舵机加标签（舵机没有序列号）</translation>
    </message>
    <message>
        <source>servo label, or number as listed by &quot;history --kind servos&quot;</source>
        <translation>舵机的标签，或“history --kind servos”列出的编号</translation>
    </message>
    <message>
        <source>new label; &quot;&quot; removes it</source>
        <translation>新标签；&quot;&quot; 表示删除标签</translation>
    </message>
    <message>
        <source>from now on, treat the servo that replies with this model and ID as a different servo, with this label; earlier entries stay with the previous servo</source>
        <translation>从现在起，把以此型号和 ID 应答的舵机视为另一个舵机，使用此标签；之前的记录仍归原来的舵机</translation>
    </message>
    <message>
        <source>save a snapshot from the history as a file for &quot;snapshot restore&quot;</source>
        <translation>把历史记录中的快照存为供 snapshot restore 使用的文件</translation>
    </message>
    <message>
        <source>snapshot number, as listed by &quot;history --kind snapshots&quot;</source>
        <translation>快照编号，见“history --kind snapshots”的输出</translation>
    </message>
    <message>
        <source>output file, for example NAME.servo.json; an existing file is replaced</source>
        <translation>输出文件，例如 NAME.servo.json；已有文件会被覆盖</translation>
    </message>
    <message>
        <source>save a servo&apos;s memory table as it was at a given time (last snapshot plus the writes up to then) to a file for &quot;snapshot restore&quot;</source>
        <translation>把舵机在某一时刻的内存表存为供 snapshot restore 使用的文件：取该时刻前的最后一个快照，加上快照之后到该时刻为止的写入</translation>
    </message>
    <message>
        <source>Bench name saved; the server is set by SERVODESK_HISTORY_SERVER</source>
        <translation>已保存工位名称；服务器由 SERVODESK_HISTORY_SERVER 指定</translation>
    </message>
    <message>
        <source>Server and bench name saved; the desktop program uses them too</source>
        <translation>已保存服务器和工位名称，桌面程序也会使用</translation>
    </message>
    <message>
        <source>Server and bench name were not saved</source>
        <translation>未保存服务器和工位名称</translation>
    </message>
    <message>
        <source>send history entries that a history server (PostgreSQL) does not have yet; no port is needed</source>
        <translation>把服务器上尚缺的历史记录发送到历史记录服务器（PostgreSQL）；不需要端口</translation>
    </message>
    <message>
        <source>name of this bench on the server</source>
        <translation>本工位在服务器上的名称</translation>
    </message>
    <message>
        <source>The LED of servo %1 is blinking. Press Ctrl-C to stop.</source>
        <translation>舵机 %1 的 LED 正在闪烁。按 Ctrl-C 停止。</translation>
    </message>
    <message>
        <source>The LED of servo %1 is back in its previous state.</source>
        <translation>舵机 %1 的 LED 设置已恢复原样。</translation>
    </message>
    <message>
        <source>blink the LED of a servo for a few seconds</source>
        <translation>让舵机的 LED 闪烁几秒</translation>
    </message>
    <message>
        <source>no, only the family</source>
        <translation>否，只知道系列</translation>
    </message>
    <message>
        <source>Family, register map</source>
        <translation>系列、内存表</translation>
    </message>
    <message>
        <source>The EPROM is unlocked because a change to this servo was interrupted. To finish or undo the change: %1</source>
        <translation>EPROM 未上锁，因为该舵机有未写完的更改。要完成或撤销该更改，请运行：%1</translation>
    </message>
    <message>
        <source>The EPROM is unlocked. To lock it: servodesk-cli write %1 lock=1</source>
        <translation>EPROM 未上锁。上锁命令：servodesk-cli write %1 lock=1</translation>
    </message>
    <message>
        <source>show the model and state of a servo and how to clear its alarms</source>
        <translation>显示舵机的型号与状态，以及报警的解除方法</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must have the form ID=POS, without spaces</source>
        <translation>“%1”应写成 ID=POS（ID=位置），中间不留空格</translation>
    </message>
    <message>
        <source>ID %1 is specified twice</source>
        <translation>重复指定了 ID %1</translation>
    </message>
    <message>
        <source>--how must be write, sync or async</source>
        <translation>--how 只能是 write（普通写）、sync（同步写）或 async（异步写）</translation>
    </message>
    <message>
        <source>set goals; values that are not specified are not written</source>
        <translation>设定目标；未指定的参数不会写入</translation>
    </message>
    <message>
        <source>goal, raw (1=2048) or with its unit (1=90deg; in speed mode 1=30rpm)</source>
        <translation>目标，写成 ID=数值：原始值（如 1=2048）或带单位的值（如 1=90deg；恒速模式如 1=30rpm）</translation>
    </message>
    <message>
        <source>wait until the servos have reached their goals</source>
        <translation>等待舵机到位</translation>
    </message>
    <message>
        <source>write: one servo at a time; sync: all in one packet; async: stored first, then started together. Starting several Feetech servos together also starts any moves that other programs have stored in servos on the bus</source>
        <translation>write：逐个写入；sync：同步写，全部放在一个数据包中；async：异步写，先存储再一起执行。一起启动多个飞特舵机时，其他程序存储在总线上各舵机中的动作也会执行</translation>
    </message>
    <message>
        <source>not a valid packet</source>
        <translation>不是有效的数据包</translation>
    </message>
    <message>
        <source>enter bytes as hexadecimal pairs: FF FF 01 02 01 FB</source>
        <translation>请用十六进制写出各字节，例如：FF FF 01 02 01 FB</translation>
    </message>
    <message>
        <source>No reply.</source>
        <translation>没有收到任何应答。</translation>
    </message>
    <message>
        <source>send raw bytes and show the reply</source>
        <translation>原样发送字节并显示应答</translation>
    </message>
    <message>
        <source>complete packet with checksum</source>
        <translation>完整的数据包，含校验和</translation>
    </message>
    <message>
        <source>read individual registers</source>
        <translation>读取指定的参数</translation>
    </message>
    <message>
        <source>register names, as shown by dump</source>
        <translation>参数的键名，见 dump 输出的“键名”列</translation>
    </message>
    <message>
        <source>No unfinished changes.</source>
        <translation>没有未写完的更改。</translation>
    </message>
    <message>
        <source>No unfinished changes on %1.</source>
        <translation>%1 上没有未写完的更改。</translation>
    </message>
    <message>
        <source>Nothing was written. Use --finish to complete the changes, --undo to restore the old values, or --forget to abandon a change whose servo will not be connected again.</source>
        <translation>未写入任何内容。用 --finish 完成更改，用 --undo 恢复原值；如果舵机不会再接上，用 --forget 放弃其更改。</translation>
    </message>
    <message>
        <source>Unfinished changes on this port:</source>
        <translation>此端口上有未写完的更改：</translation>
    </message>
    <message>
        <source>no unfinished change &quot;%1&quot;</source>
        <translation>没有未写完的更改“%1”</translation>
    </message>
    <message>
        <source>the names of several changes start with &quot;%1&quot;</source>
        <translation>有多个更改的名称以“%1”开头</translation>
    </message>
    <message>
        <source>use either --finish or --undo, not both</source>
        <translation>--finish 和 --undo 只能选一个</translation>
    </message>
    <message>
        <source>show unfinished changes, and finish or undo them</source>
        <translation>显示未写完的更改，并可完成或撤销</translation>
    </message>
    <message>
        <source>complete the changes</source>
        <translation>完成这些更改</translation>
    </message>
    <message>
        <source>restore the old values</source>
        <translation>恢复原值</translation>
    </message>
    <message>
        <source>only this change (the first characters of its name are enough)</source>
        <translation>仅处理此更改（写出名称的前几个字符即可）</translation>
    </message>
    <message>
        <source>include changes started on ports that no longer exist and, with --change, on ports that still exist. The exit code is 1 while changes started on other ports are unfinished</source>
        <translation>也处理在其他端口上开始的更改：端口已不存在的直接处理，端口仍然存在的须加 --change。只要其他端口上开始的更改还有未写完的，退出码就为 1</translation>
    </message>
    <message>
        <source>restore the parameters stored in the servo (instruction 0x06); the ID and baud rate may change, so connect only this servo</source>
        <translation>恢复舵机内备份的参数（指令 0x06）；ID 和波特率可能改变，请只接这一个舵机</translation>
    </message>
    <message>
        <source>possibly two servos with this ID</source>
        <translation>可能有两个舵机使用此 ID</translation>
    </message>
    <message>
        <source>family unclear, so read-only</source>
        <translation>系列不明，因此只读</translation>
    </message>
    <message>
        <source>Model number</source>
        <translation>型号编号</translation>
    </message>
    <message>
        <source>No servo replied. Check the power supply and wiring, and try --bauds all.</source>
        <translation>没有舵机应答。请检查供电和接线，并用 --bauds all 再试。</translation>
    </message>
    <message>
        <source>Searched at %1 baud. Only Feetech servos use 1000000 baud; LX, Modbus and most SMS servos use 115200.</source>
        <translation>已搜索的波特率：%1。只有飞特舵机使用 1000000；LX、Modbus 和多数 SMS 舵机使用 115200。</translation>
    </message>
    <message>
        <source>Unreadable data was received, but no servo could be confirmed. Possible causes: a different baud rate, two servos with the same ID, or noise.</source>
        <translation>收到无法识别的数据，但无法确认有舵机。可能的原因：波特率不同、ID 重复，或有干扰。</translation>
    </message>
    <message>
        <source>Several servos replied late, so others may have been missed. Try again with --slow.</source>
        <translation>有几个舵机应答偏晚，可能漏掉了其他舵机。请加 --slow 再搜索一次。</translation>
    </message>
    <message>
        <source>This adapter does not support %1 baud.</source>
        <translation>此适配器不支持波特率 %1。</translation>
    </message>
    <message>
        <source>At %1 baud, the bus is never idle: a device is sending continuously. Servos may have been missed.</source>
        <translation>波特率为 %1 时，总线一直没有空闲：有设备在不停地发送数据。可能漏掉了舵机。</translation>
    </message>
    <message>
        <source>The search was stopped early.</source>
        <translation>搜索中途停止。</translation>
    </message>
    <message>
        <source>only these IDs (default: 0-253)</source>
        <translation>只搜索这些 ID（默认：0-253）</translation>
    </message>
    <message>
        <source>retry IDs that did not reply, using a longer timeout</source>
        <translation>用更长的超时再次查询没有应答的 ID</translation>
    </message>
    <message>
        <source>file created by &quot;snapshot save&quot;</source>
        <translation>由 snapshot save 生成的文件</translation>
    </message>
    <message>
        <source>&quot;default&quot; must be combined with a servo, or with a file of a known model</source>
        <translation>“default”须与舵机或已知型号的文件一起给出</translation>
    </message>
    <message>
        <source>specify at least two sources: files, IDs or &quot;default&quot;</source>
        <translation>请至少给出两个来源：文件、ID 或 default</translation>
    </message>
    <message>
        <source>compare memory tables from files, servos and the factory defaults side by side</source>
        <translation>并排对比内存表：文件、舵机、出厂默认值</translation>
    </message>
    <message>
        <source>two or more sources: file, ID (reads the servo) or default; ./5 is a file named 5</source>
        <translation>两个或更多来源：文件、ID（读取该舵机）或 default；./5 表示名为 5 的文件</translation>
    </message>
    <message>
        <source>also show rows that are identical, unknown or read-only</source>
        <translation>也显示相同、未知或只读的行</translation>
    </message>
    <message>
        <source>write a saved file back to a servo: turn torque off, write only the differences, read each row back</source>
        <translation>把保存的文件写回舵机：先卸力，只写入有差异的行，并逐行回读</translation>
    </message>
    <message>
        <source>snapshot or template; may be from another servo</source>
        <translation>快照或模板，也可来自另一个舵机</translation>
    </message>
    <message>
        <source>also write the ID and baud rate, as the last step</source>
        <translation>也写入 ID 和波特率（放在最后写入）</translation>
    </message>
    <message>
        <source>--size is required</source>
        <translation>缺少 --size</translation>
    </message>
    <message>
        <source>%1 cannot be used in a trial; available on this servo: %2</source>
        <translation>%1 不能试用；该舵机可用：%2</translation>
    </message>
    <message>
        <source>The trial has ended. The servo has its old values again unless a note says otherwise. To save values that worked well, use &quot;write&quot;.</source>
        <translation>试用已结束。如果上面没有恢复失败的提示，舵机已恢复原值。要保存效果好的值，请使用“write”。</translation>
    </message>
    <message>
        <source>measure the step response of a servo, before and after changing its gains</source>
        <translation>测量舵机的阶跃响应，可对比修改增益前后</translation>
    </message>
    <message>
        <source>step size: raw value, or value with its unit (30deg)</source>
        <translation>阶跃大小：原始值，或带单位的数值（30deg）</translation>
    </message>
    <message>
        <source>start position (default: present position, if there is enough room)</source>
        <translation>起始位置（默认：行程余量足够时为当前位置）</translation>
    </message>
    <message>
        <source>number of back-and-forth movements (default: 3)</source>
        <translation>往返次数（默认：3）</translation>
    </message>
    <message>
        <source>time from one goal to the next (default: automatic)</source>
        <translation>从一个目标到下一个目标的时间（默认：自动）</translation>
    </message>
    <message>
        <source>raw value, or value with its unit (default: as fast as possible)</source>
        <translation>原始值，或带单位的数值（默认：最快）</translation>
    </message>
    <message>
        <source>values for a second run: position_p=40,position_d=20; the old values are restored afterwards</source>
        <translation>第二次运行使用的值：position_p=40,position_d=20；之后恢复原值</translation>
    </message>
    <message>
        <source>Gaps in the readings: %1. Times and speeds are not available for moves that contain a gap.</source>
        <translation>无采样数据的时段：%1。包含此类时段的行程不给出时间和速度。</translation>
    </message>
    <message>
        <source>the report file name must end with .html, .pdf, .json or .csv</source>
        <translation>报告文件名须以 .html、.pdf、.json 或 .csv 结尾</translation>
    </message>
    <message>
        <source>Servo %1: most moves are too short for a verdict. A goal counts as reached within %2 steps, so each move must be at least %3 steps long.</source>
        <translation>舵机 %1：大多数行程太短，无法得出结论。距目标 %2 步以内即视为到位，因此每个行程至少需要 %3 步。</translation>
    </message>
    <message>
        <source>Servo %1: the sine wave is too fast for the servo. Use a period of at least %2 ms.</source>
        <translation>舵机 %1：此正弦运动所需的速度超过舵机的最高速度。周期至少需要 %2 毫秒。</translation>
    </message>
    <message>
        <source>Servo %1: the delay is too short for the longest move, so the servo reverses before it arrives. A delay of %2 ms is enough.</source>
        <translation>舵机 %1：延时短于最长行程所需的时间，舵机未到位就会折返。延时 %2 毫秒即可。</translation>
    </message>
    <message>
        <source>moving to the start position or warming up</source>
        <translation>正在前往起始位置或预热</translation>
    </message>
    <message>
        <source>run a sweep test and evaluate the result</source>
        <translation>对舵机运行扫描测试并评定结果</translation>
    </message>
    <message>
        <source>the file name of a comparison report must end with .html</source>
        <translation>对比报告的文件名须以 .html 结尾</translation>
    </message>
    <message>
        <source>compare two sweep tests; no port is needed</source>
        <translation>对比两次扫描测试；不需要端口</translation>
    </message>
    <message>
        <source>test run in the history (12, or 12:3 for ID 3 of that run), or a .json report file</source>
        <translation>历史记录中的测试记录（12，或 12:3 表示其中的 ID 3），或 .json 报告文件</translation>
    </message>
    <message>
        <source>test run to compare with the first one</source>
        <translation>第二个测试记录，与第一个对比</translation>
    </message>
    <message>
        <source>servo to compare, if a run has several</source>
        <translation>要对比的舵机（记录含多个舵机时）</translation>
    </message>
    <message>
        <source>save the comparison as a web page (.html)</source>
        <translation>将对比保存为网页（.html）</translation>
    </message>
    <message>
        <source>create a report of an earlier sweep test; no port is needed</source>
        <translation>生成以往扫描测试的报告；不需要端口</translation>
    </message>
    <message>
        <source>test run number in the history, or a .json report file</source>
        <translation>历史记录中的测试记录编号，或 .json 报告文件</translation>
    </message>
    <message>
        <source>report file; its extension sets the format: .html, .pdf, .json or .csv</source>
        <translation>报告文件；扩展名决定格式：.html、.pdf、.json 或 .csv</translation>
    </message>
    <message>
        <source>No matching test runs.</source>
        <translation>没有符合条件的测试记录。</translation>
    </message>
    <message>
        <source>a reference must be a test run in the history, for example 12, or 12:3 for ID 3 of that run</source>
        <translation>参考须为历史记录中的测试记录，例如 12，或 12:3（该记录中的 ID 3）</translation>
    </message>
    <message>
        <source>Test run %1, ID %2, is now the reference for %3</source>
        <translation>已将测试记录 %1 中 ID %2 的结果设为 %3 的参考</translation>
    </message>
    <message>
        <source>Test run %1, ID %2, is no longer a reference for %3</source>
        <translation>测试记录 %1 中 ID %2 的结果不再是 %3 的参考</translation>
    </message>
    <message>
        <source>list the sweep tests in the history; no port is needed</source>
        <translation>列出历史记录中的扫描测试；不需要端口</translation>
    </message>
    <message>
        <source>only runs whose label, note, operator or port contains this text</source>
        <translation>仅限标签、备注、操作员或端口中含此文字的记录</translation>
    </message>
    <message>
        <source>mark a servo in a test run as the reference for its model</source>
        <translation>将测试记录中的某个舵机设为其型号的参考</translation>
    </message>
    <message>
        <source>test run number in the history: 12, or 12:3 for ID 3 of that run</source>
        <translation>历史记录中的测试记录编号：12，或 12:3（其中的 ID 3）</translation>
    </message>
    <message>
        <source>remove the reference mark</source>
        <translation>取消参考标记</translation>
    </message>
    <message>
        <source>%1 identifies the servo and is included in a template only with --identity</source>
        <translation>%1 用于识别舵机；只有使用 --identity 时，模板才会包含该参数</translation>
    </message>
    <message>
        <source>%1 is read-only</source>
        <translation>%1 只读</translation>
    </message>
    <message>
        <source>the snapshot or servo has no value for %1</source>
        <translation>快照或舵机中没有 %1 的值</translation>
    </message>
    <message>
        <source>save selected registers as a template to write to other servos</source>
        <translation>将选定的参数存为模板，用于写入其他舵机</translation>
    </message>
    <message>
        <source>snapshot file, or ID (reads the servo)</source>
        <translation>快照文件，或 ID（读取该舵机）</translation>
    </message>
    <message>
        <source>register names</source>
        <translation>参数的键名</translation>
    </message>
    <message>
        <source>allow ID and baud rate in the template</source>
        <translation>允许模板包含 ID 和波特率</translation>
    </message>
    <message>
        <source>write a template or snapshot to several servos and report the result for each; never writes the ID or baud rate</source>
        <translation>把模板或快照写入多个舵机，并逐个给出结果；不会写入 ID 和波特率</translation>
    </message>
    <message>
        <source>template or snapshot</source>
        <translation>模板或快照</translation>
    </message>
    <message>
        <source>servo IDs: 1, 1-6 or 1,3,5</source>
        <translation>舵机 ID：1、1-6 或 1,3,5</translation>
    </message>
    <message>
        <source>the last argument must be on, off or damp</source>
        <translation>最后一个参数应为 on（打开）、off（关闭）或 damp（阻尼）</translation>
    </message>
    <message>
        <source>Querying</source>
        <translation>正在查询</translation>
    </message>
    <message>
        <source>Canceled before confirmation (ID %1): the torque-off command was sent but may not have taken effect.</source>
        <translation>您在舵机确认前中止了操作（ID %1）：卸力指令已发送，但可能尚未生效。</translation>
    </message>
    <message>
        <source>Canceled before confirmation (ID %1): torque may still be on, and these servos may still be moving.</source>
        <translation>您在舵机确认前中止了操作（ID %1）：这些舵机可能仍有扭矩，也可能仍在运动。</translation>
    </message>
    <message>
        <source>Canceled before anything was sent (ID %1).</source>
        <translation>您在发送任何指令前中止了操作（ID %1）。</translation>
    </message>
    <message>
        <source>Canceled before confirmation (ID %1): the torque state of these servos may have changed.</source>
        <translation>您在舵机确认前中止了操作（ID %1）：这些舵机的扭矩状态可能已改变。</translation>
    </message>
    <message>
        <source>No reply yet (ID %1): trying again after the other servos.</source>
        <translation>暂无应答（ID %1）：处理完其他舵机后再次尝试。</translation>
    </message>
    <message>
        <source>unknown mode &quot;%1&quot;; available modes: %2</source>
        <translation>未知模式“%1”；可用的模式：%2</translation>
    </message>
    <message>
        <source>set the torque state: on holds the present position; off is sent even when other writes are refused</source>
        <translation>设置扭矩状态：on 保持当前位置；即使其他写入被拒绝，off 也会发送</translation>
    </message>
    <message>
        <source>servo IDs (1 2 3, 1-6 or 1,3), then the action</source>
        <translation>舵机 ID（1 2 3、1-6 或 1,3），最后是要做的操作</translation>
    </message>
    <message>
        <source>stop the motion without changing the torque state; if it cannot be confirmed that the servo is holding its position, torque is turned off</source>
        <translation>停止运动；扭矩状态不变，但如果无法确认舵机已保持位置，则卸力</translation>
    </message>
    <message>
        <source>the tour writes to servos and moves them, so it only runs on a simulated bus: --port sim:demo</source>
        <translation>演示会写入参数并转动舵机，只能在模拟总线上运行：--port sim:demo</translation>
    </message>
    <message>
        <source>run a guided tour on a simulated bus; no servo is needed</source>
        <translation>在模拟总线上演示功能；不需要舵机</translation>
    </message>
    <message>
        <source>read servo feedback continuously</source>
        <translation>连续读取舵机反馈</translation>
    </message>
    <message>
        <source>readings per second for each servo (default: 20)</source>
        <translation>每个舵机每秒读取次数（默认：20）</translation>
    </message>
    <message>
        <source>end after this many seconds (default: run until Ctrl-C)</source>
        <translation>运行指定的秒数后结束（默认：按 Ctrl-C 结束）</translation>
    </message>
    <message>
        <source>raw value (85), physical value with unit (8.5V, 90deg) or name (position)</source>
        <translation>数值可写原始值（85）、带单位的物理值（8.5V、90deg）或名称（position）</translation>
    </message>
    <message>
        <source>leave the EPROM locked: changes are lost at power-off</source>
        <translation>不解锁 EPROM：断电后恢复原值</translation>
    </message>
    <message numerus="yes">
        <source>Settings of %n servo(s) saved to %1 (ID %2)</source>
        <translation>
            <numerusform>已把 %n 个舵机的参数保存到 %1（ID %2）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) written to %1</source>
        <translation>
            <numerusform>已向 %1 写入 %n 行</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) sent to %1 from bench %2; the server is now up to date</source>
        <translation>
            <numerusform>已从工位 %2 向 %1 发送 %n 行；服务器数据已是最新</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n change(s) abandoned</source>
        <translation>
            <numerusform>已放弃 %n 个更改</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n servo(s) found on %1 in %2 s</source>
        <translation>
            <numerusform>在 %1 上找到 %n 个舵机，用时 %2 秒</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Servo %1, %2: %n register(s) saved to %3</source>
        <translation>
            <numerusform>舵机 %1，%2：已把 %n 个参数保存到 %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s) in %1 s, %2 missed</source>
        <translation>
            <numerusform>采样 %n 次，用时 %1 秒，丢失 %2 次</numerusform>
        </translation>
    </message>
    <message>
        <source>Position correction</source>
        <translation>位置校正</translation>
    </message>
    <message>
        <source>The alarms could not be saved to the history: %1 (%2)</source>
        <translation>报警未能存入历史记录：%1（%2）</translation>
    </message>
    <message>
        <source>Present settings saved to %1</source>
        <translation>当前参数已保存到 %1</translation>
    </message>
    <message>
        <source>Present</source>
        <translation>当前值</translation>
    </message>
    <message>
        <source>no history server is set; set one with --server or SERVODESK_HISTORY_SERVER</source>
        <translation>未设置历史记录服务器；请用 --server 或 SERVODESK_HISTORY_SERVER 指定</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Register map</source>
        <translation>内存表</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Result saved to %1</source>
        <translation>结果已保存到 %1</translation>
    </message>
    <message>
        <source>switch servos in other modes to position mode for the test, then back</source>
        <translation>处于其他模式的舵机在测试期间切换到位置模式，结束后切换回来</translation>
    </message>
    <message>
        <source>no data from a bench named %1 on this server; available benches: %2</source>
        <translation>此服务器上没有工位 %1 的数据；现有工位：%2</translation>
    </message>
    <message>
        <source>read from a history server: its connection string, or &quot;default&quot; for the configured server</source>
        <translation>读取历史记录服务器：填连接字符串，或用“default”表示已设置的服务器</translation>
    </message>
    <message>
        <source>only data sent to the server by the bench with this name</source>
        <translation>仅显示该工位发送到服务器的数据</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a valid ID; IDs must be 0 to 253</source>
        <translation>“%1”不是有效的 ID；ID 须为 0 到 253</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ID range; example: 1-20</source>
        <translation>“%1”不是 ID 范围；例如 1-20</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number from %2 to %3</source>
        <translation>“%1”不是 %2 到 %3 之间的整数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number above 0</source>
        <translation>“%1”不是大于 0 的数</translation>
    </message>
    <message>
        <source>unsupported baud rate &quot;%1&quot; (%2)</source>
        <translation>不支持的波特率“%1”（%2）</translation>
    </message>
    <message>
        <source>unknown protocol &quot;%1&quot; (auto, feetech, modbus, lx)</source>
        <translation>未知协议“%1”（auto、feetech、modbus、lx）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must have the form KEY=VALUE, without spaces</source>
        <translation>“%1”应写成 KEY=VALUE（键名=数值），中间不留空格</translation>
    </message>
    <message>
        <source>only entries since this time: 2026-11-22, 2026-11-22T10:30, 10:30, or an age such as 90m, 2h, 3d, 1w</source>
        <translation>仅限此时间之后的记录：2026-11-22、2026-11-22T10:30、10:30，或距现在的时长，如 90m、2h、3d、1w</translation>
    </message>
    <message>
        <source>only entries before this time</source>
        <translation>仅限此时间之前的记录</translation>
    </message>
    <message>
        <source>only writes that failed and alarms that are still active</source>
        <translation>仅限失败的写入和尚未解除的报警</translation>
    </message>
    <message>
        <source>maximum number of rows, newest first (default: 200)</source>
        <translation>最多显示的行数，从最新的开始（默认：200）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a valid time; examples: 2026-11-22, 2026-11-22T10:30, 10:30, or an age such as 90m, 2h, 3d, 1w</source>
        <translation>“%1”不是有效的时间；例如：2026-11-22、2026-11-22T10:30、10:30，或距现在的时长，如 90m、2h、3d、1w</translation>
    </message>
    <message>
        <source>no servo &quot;%1&quot; in the history; &quot;history --kind servos&quot; lists all servos</source>
        <translation>历史记录中没有舵机“%1”；“history --kind servos”可列出全部舵机</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not valid; expected: %2</source>
        <translation>“%1”无效；应为：%2</translation>
    </message>
    <message>
        <source>use only one of --step, --both-sides, --random, --sine and --points</source>
        <translation>--step、--both-sides、--random、--sine 和 --points 只能选一个</translation>
    </message>
    <message>
        <source>--points cannot be combined with --from or --to</source>
        <translation>使用 --points 时不能用 --from 和 --to</translation>
    </message>
    <message>
        <source>--from and --to are required</source>
        <translation>需要 --from 和 --to</translation>
    </message>
    <message>
        <source>use either --delay or --dwell, not both</source>
        <translation>--delay 和 --dwell 只能选一个</translation>
    </message>
    <message>
        <source>--delay or --dwell is required</source>
        <translation>需要 --delay 或 --dwell</translation>
    </message>
    <message>
        <source>start position: raw value (1024), or value with its unit (90deg)</source>
        <translation>起始位置：原始值（1024），或带单位的数值（90deg）</translation>
    </message>
    <message>
        <source>end position: raw value, or value with its unit</source>
        <translation>结束位置：原始值，或带单位的数值</translation>
    </message>
    <message>
        <source>time from one goal to the next, whether or not the goal is reached</source>
        <translation>从一个目标到下一个目标的时间，不管是否到位</translation>
    </message>
    <message>
        <source>pause after each goal is reached, instead of --delay</source>
        <translation>每次到位后停留的时间（代替 --delay）</translation>
    </message>
    <message>
        <source>end after this many seconds</source>
        <translation>运行指定的秒数后结束</translation>
    </message>
    <message>
        <source>move in steps of this size, up and down</source>
        <translation>按此步长逐步往返</translation>
    </message>
    <message>
        <source>also approach the middle of the range from both directions</source>
        <translation>另外从两个方向到达行程范围的中间</translation>
    </message>
    <message>
        <source>move to random goals; the same seed gives the same goals</source>
        <translation>按随机目标运动；种子相同则目标相同</translation>
    </message>
    <message>
        <source>follow a sine wave with this period</source>
        <translation>按此周期做正弦运动</translation>
    </message>
    <message>
        <source>read goals from a CSV file: goal,pause in ms</source>
        <translation>从 CSV 文件读取目标：目标,停留毫秒数</translation>
    </message>
    <message>
        <source>warm-up time in seconds before measuring</source>
        <translation>测量前的预热时间（秒）</translation>
    </message>
    <message>
        <source>turn torque off at the end (default: hold)</source>
        <translation>结束时卸力（默认：保持）</translation>
    </message>
    <message>
        <source>limits for the verdict (default: built-in limits)</source>
        <translation>判定所用的限值（默认：内置限值）</translation>
    </message>
    <message>
        <source>write the report to this file, and the readings to a CSV file next to it</source>
        <translation>将报告写入此文件，采样数据写入同一目录下的 CSV 文件</translation>
    </message>
    <message>
        <source>operator name for the report</source>
        <translation>操作员姓名，写入报告</translation>
    </message>
    <message>
        <source>note for the report</source>
        <translation>备注，写入报告</translation>
    </message>
    <message>
        <source>some old and some new values</source>
        <translation>部分为新值，部分为原值</translation>
    </message>
    <message>
        <source>different servo; not changed</source>
        <translation>应答的是另一个舵机：未作更改</translation>
    </message>
    <message>
        <source>no reply</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>replies cannot be decoded</source>
        <translation>应答无法解析</translation>
    </message>
    <message>
        <source>still in progress in another program</source>
        <translation>更改仍在另一个程序中进行</translation>
    </message>
    <message>
        <source>value has changed in the meantime; left as is</source>
        <translation>数值后来又有变动，保持不变</translation>
    </message>
    <message numerus="yes">
        <source>%n register(s)</source>
        <translation>
            <numerusform>%n 个参数</numerusform>
        </translation>
    </message>
    <message>
        <source>Unfinished change %1:</source>
        <translation>未写完的更改 %1：</translation>
    </message>
    <message>
        <source>The EPROM may be unlocked. To check, use &quot;info %1&quot;. To lock the EPROM, turn the servo off and on.</source>
        <translation>EPROM 可能没有上锁。用“info %1”可以查看；要给 EPROM 上锁，请将舵机断电再上电。</translation>
    </message>
    <message>
        <source>not changed</source>
        <translation>未更改</translation>
    </message>
    <message>
        <source>In change %1, these registers were not written because their values have changed in the meantime or because writing them would move the servo: %2</source>
        <translation>更改 %1：以下参数未写入，因为其数值后来又有变动，或写入会使舵机转动：%2</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Still in progress in another program, which will finish the change: %1</source>
        <translation>以下更改仍在另一个程序中进行，将由该程序完成：%1</translation>
    </message>
    <message>
        <source>Port %1 still exists. To list its changes (%2): %3</source>
        <translation>端口 %1 仍可用。要查看该端口上未写完的更改（%2），请运行：%3</translation>
    </message>
    <message>
        <source>ServoDesk cannot distinguish the servo from another one with the same model and ID. Run the following only if you are sure that the same servo is now connected to %1: %2</source>
        <translation>ServoDesk 无法区分该舵机与型号和 ID 相同的另一个舵机。只有确定现在接在 %1 上的就是同一个舵机，才可运行：%2</translation>
    </message>
    <message>
        <source>An adapter may get a different port name when it is plugged in again. To list the changes, use the port to which the servo is now connected: %1</source>
        <translation>适配器重新插上后端口名可能改变。要列出更改，请使用舵机现在所接的端口：%1</translation>
    </message>
    <message>
        <source>Unfinished changes from other ports:</source>
        <translation>在其他端口上开始、尚未写完的更改：</translation>
    </message>
    <message>
        <source>Change %1 was started on %2, which still exists. You have confirmed that the servo on %3 is the same servo.</source>
        <translation>更改 %1 是在 %2 上开始的，该端口仍然存在。您已确认 %3 上接的是同一个舵机。</translation>
    </message>
    <message>
        <source>On the command line, use the option %1 to confirm.</source>
        <translation>在命令行中，用选项 %1 确认。</translation>
    </message>
    <message>
        <source>  Example: %1</source>
        <translation>  例如：%1</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>跳过</translation>
    </message>
    <message>
        <source>The file is from a different model: registers are matched by name.</source>
        <translation>文件来自另一型号，参数按名称对应。</translation>
    </message>
    <message>
        <source>Voltage, temperature, current and torque limits are not restored by default; to write one, specify --only KEY --dangerous.</source>
        <translation>电压、温度、电流和扭矩的限值默认不恢复；如需写入其中一项，请指明参数的键名：--only 键名 --dangerous。</translation>
    </message>
    <message>
        <source>The file is from a different firmware version: registers are matched by name.</source>
        <translation>文件来自另一固件版本，参数按名称对应。</translation>
    </message>
    <message>
        <source>%1, old value restored</source>
        <translation>%1，已恢复原值</translation>
    </message>
    <message>
        <source>only these registers: KEY,KEY</source>
        <translation>仅限这些参数：键名,键名</translation>
    </message>
    <message>
        <source>include values that are lost at power-off (acceleration, torque limit)</source>
        <translation>也包括断电后丢失的值（加速度、扭矩限制）</translation>
    </message>
    <message>
        <source>allow writing registers that can move the servo or make it unreachable</source>
        <translation>允许写入可能使舵机失联或转动的参数</translation>
    </message>
    <message>
        <source>undo all writes at the first failure (default: stop without undoing)</source>
        <translation>首次失败时撤销全部写入（默认：停止，不撤销）</translation>
    </message>
    <message>
        <source>show what would be written, without writing</source>
        <translation>显示将要写入的内容，不写入</translation>
    </message>
    <message>
        <source>save the result of each row (.csv or .json)</source>
        <translation>保存每一行的结果（.csv 或 .json）</translation>
    </message>
    <message>
        <source>--only requires at least one register</source>
        <translation>--only 后至少要给出一个参数的键名</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>新值</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) skipped: %1</source>
        <translation>
            <numerusform>跳过 %n 行：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>The change is still unfinished. To see it: servodesk-cli recover</source>
        <translation>此次更改仍未写完。要查看，请运行：servodesk-cli recover</translation>
    </message>
    <message>
        <source>The table shows the values now in the servo. The snapshot taken before the first write contains the old values.</source>
        <translation>表中显示的是舵机中现在的值。第一次写入前保存的快照中有原值。</translation>
    </message>
    <message>
        <source>Could not be restored: %1.</source>
        <translation>未能恢复原值：%1。</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) skipped</source>
        <translation>
            <numerusform>跳过 %n 行</numerusform>
        </translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation>多余的参数“%1”</translation>
    </message>
    <message>
        <source>a command is required; --help lists all commands</source>
        <translation>请给出命令；--help 列出全部命令</translation>
    </message>
    <message>
        <source>an option has no value or is used twice (%1)</source>
        <translation>选项缺少数值，或重复使用（%1）</translation>
    </message>
    <message>
        <source>device path, tcp://HOST:PORT, or a simulated bus (reset at each start): sim:demo, sim:trouble, sim:modbus, sim:lx, sim:sts3215@1,lx16a@2</source>
        <translation>设备路径、tcp://主机:端口，或模拟总线（每次启动时重置）：sim:demo、sim:trouble、sim:modbus、sim:lx、sim:sts3215@1,lx16a@2</translation>
    </message>
    <message>
        <source>baud rate, or auto to try all (default: 1000000; 115200 for LX and Modbus)</source>
        <translation>波特率；auto 表示逐个尝试所有波特率（默认：1000000；LX 和 Modbus 为 115200）</translation>
    </message>
    <message>
        <source>servo protocol: auto, feetech, modbus or lx (default: auto, which tries all protocols possible at the baud rate)</source>
        <translation>舵机使用的协议：auto、feetech、modbus 或 lx（默认：auto，即尝试该波特率下所有可能的协议）</translation>
    </message>
    <message>
        <source>number of retries after a communication error</source>
        <translation>通信出错时的重试次数</translation>
    </message>
    <message>
        <source>silence between Modbus frames in microseconds (default: 1750 above 19200 baud, as in the standard)</source>
        <translation>Modbus 帧间静默时间（微秒；默认按标准，波特率高于 19200 时为 1750）</translation>
    </message>
    <message>
        <source>output language</source>
        <translation>输出的语言</translation>
    </message>
    <message>
        <source>unsupported language &quot;%1&quot; (en, zh_CN)</source>
        <translation>不支持的语言“%1”（en、zh_CN）</translation>
    </message>
    <message>
        <source>no adapter is connected; select a port with --port: %1</source>
        <translation>没有连接适配器；请用 --port 选择端口：%1</translation>
    </message>
    <message>
        <source>several adapters are connected; select one with --port: %1</source>
        <translation>连接了多个适配器；请用 --port 选择其中一个：%1</translation>
    </message>
    <message>
        <source>A change on this port was interrupted (servo ID %1). To see, finish or undo the change: %2</source>
        <translation>此端口上有未写完的更改（ID %1）。要查看、完成或撤销，请运行：%2</translation>
    </message>
    <message>
        <source>Servo %1 replies at %2 baud.</source>
        <translation>舵机 %1 以波特率 %2 应答。</translation>
    </message>
    <message>
        <source>The settings of servo %1 could not be saved, so nothing was written to it.</source>
        <translation>未能保存舵机 %1 的设置，因此未向其写入任何内容。</translation>
    </message>
    <message>
        <source>No settings were changed, so %1 was deleted.</source>
        <translation>设置均未更改，因此已删除 %1。</translation>
    </message>
    <message>
        <source>Saved to the history as test run %1</source>
        <translation>已存入历史记录（测试编号 %1）</translation>
    </message>
    <message>
        <source>The test could not be saved to the history: %1</source>
        <translation>测试结果无法存入历史记录：%1</translation>
    </message>
    <message>
        <source>The test could not be saved to a file in the history folder either</source>
        <translation>测试结果也无法存入历史记录所在的文件夹</translation>
    </message>
    <message>
        <source>The test was saved to %1 instead</source>
        <translation>测试结果已改存到 %1</translation>
    </message>
    <message>
        <source>After the test, servo %1 could not be stopped (%2). Torque may still be on, and the servo may continue to its last goal. Use &quot;torque %1 off&quot;, or disconnect its power supply.</source>
        <translation>测试结束后未能使舵机 %1 停止（%2）。扭矩可能仍然打开，舵机可能继续向最后的目标运动。请使用“torque %1 off”，或切断其供电。</translation>
    </message>
    <message>
        <source>After the test, torque could not be turned off on servo %1 (%2) and may still be on. Use &quot;torque %1 off&quot;, or disconnect the servo from its power supply.</source>
        <translation>测试后舵机 %1 卸力失败（%2），扭矩可能仍然打开。请使用“torque %1 off”，或切断其供电。</translation>
    </message>
    <message>
        <source>%1 contains servos %2; choose one, for example %1:%3, or use --servo</source>
        <translation>%1 中有舵机 %2；请指明是哪一个，例如 %1:%3，或使用 --servo</translation>
    </message>
    <message>
        <source>
Totals: servos found %1, requests %2, replies %3, retries %4; median reply time below %5 ms.</source>
        <translation>
总计：找到舵机 %1 个；请求 %2 次，应答 %3 次，重试 %4 次；应答用时中位数小于 %5 毫秒。</translation>
    </message>
    <message>
        <source>Change two values: one kept after power-off, one lost at power-off</source>
        <translation>修改两个数值：一个断电后保留，一个断电后丢失</translation>
    </message>
    <message>
        <source>On the bus: settings read, EPROM unlocked, value written and read back, EPROM locked and checked.</source>
        <translation>总线上的过程：读取参数、EPROM 解锁、写入数值并回读、EPROM 上锁并确认。</translation>
    </message>
    <message>
        <source>Turn the power to all servos off and on again</source>
        <translation>所有舵机断电再上电</translation>
    </message>
    <message>
        <source>Restore the old value</source>
        <translation>恢复原值</translation>
    </message>
    <message numerus="yes">
        <source>%n servo(s) found in %1 s</source>
        <translation>
            <numerusform>找到 %n 个舵机，用时 %1 秒</numerusform>
        </translation>
    </message>
    <message>
        <source>no servo on this bus is in position mode and free of alarms</source>
        <translation>此总线上找不到可用的舵机（须处于位置模式且无报警）</translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) in the table</source>
        <translation>
            <numerusform>内存表中的参数：%n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>A snapshot before any change</source>
        <translation>修改之前先保存快照</translation>
    </message>
    <message>
        <source>Alarms and how to clear them</source>
        <translation>报警及解除方法</translation>
    </message>
    <message>
        <source>Goal %1, reached %2 after %3 s</source>
        <translation>目标 %1，用时 %3 秒到达 %2</translation>
    </message>
    <message>
        <source>The %1 with ID %2, servo #%3, no longer has a label</source>
        <translation>ID 为 %2 的 %1（舵机 #%3）不再有标签</translation>
    </message>
    <message>
        <source>The %1 with ID %2, servo #%3, now has the label &quot;%4&quot;</source>
        <translation>ID 为 %2 的 %1（舵机 #%3）的标签现为“%4”</translation>
    </message>
    <message>
        <source>only this servo: its label, or its number as listed by &quot;history --kind servos&quot;</source>
        <translation>仅限此舵机：填写其标签，或“history --kind servos”列出的编号</translation>
    </message>
    <message>
        <source>only servos with this label</source>
        <translation>仅限带此标签的舵机</translation>
    </message>
    <message>
        <source>several servos have the label &quot;%1&quot;; specify a number instead, as listed by &quot;history --kind servos&quot;</source>
        <translation>有几个舵机的标签都是“%1”；请改用“history --kind servos”列出的编号</translation>
    </message>
    <message>
        <source>%1 contains no step response</source>
        <translation>%1 中没有阶跃响应</translation>
    </message>
    <message>
        <source>create a report of an earlier step response; no port is needed</source>
        <translation>生成以往阶跃响应的报告；不需要端口</translation>
    </message>
    <message>
        <source>compare two step responses; no port is needed</source>
        <translation>对比两次阶跃响应；不需要端口</translation>
    </message>
    <message>
        <source>step response before the change: number in the history, or a .json report file</source>
        <translation>更改前的阶跃响应：历史记录中的编号，或 .json 报告文件</translation>
    </message>
    <message>
        <source>step response after the change</source>
        <translation>更改后的阶跃响应</translation>
    </message>
    <message>
        <source>write both step responses to a file</source>
        <translation>把两次阶跃响应写入文件</translation>
    </message>
    <message>
        <source>list the step responses in the history; no port is needed</source>
        <translation>列出历史记录中的阶跃响应；不需要端口</translation>
    </message>
    <message>
        <source>no step response %1 in the history; &quot;step-runs&quot; lists all step responses</source>
        <translation>历史记录中没有阶跃响应 %1；“step-runs”可列出全部阶跃响应</translation>
    </message>
    <message>
        <source>simulated bus: %1</source>
        <translation>模拟总线：%1</translation>
    </message>
    <message>
        <source>Find and read:</source>
        <translation>查找与读取：</translation>
    </message>
    <message>
        <source>Write:</source>
        <translation>写入：</translation>
    </message>
    <message>
        <source>Move and watch:</source>
        <translation>运动与监视：</translation>
    </message>
    <message>
        <source>Test:</source>
        <translation>测试：</translation>
    </message>
    <message>
        <source>Save and restore:</source>
        <translation>保存与恢复：</translation>
    </message>
    <message>
        <source>History:</source>
        <translation>历史记录：</translation>
    </message>
    <message>
        <source>Tools:</source>
        <translation>工具：</translation>
    </message>
    <message>
        <source>reply timeout in milliseconds, in addition to the transmission time (default: 25, longer for slow adapters; a servo counts as silent after 500 ms)</source>
        <translation>应答超时（毫秒），不含传输时间（默认：25，适配器慢时更长；超过 500 毫秒才判定舵机无应答）</translation>
    </message>
    <message>
        <source>Examples:</source>
        <translation>示例：</translation>
    </message>
    <message>
        <source>New servos all have the same ID. Connect them one at a time and give each its own ID: servodesk-cli commission --help</source>
        <translation>新舵机的 ID 都相同。请逐个连接，并为每个舵机设置各自的 ID：servodesk-cli commission --help</translation>
    </message>
    <message>
        <source>Cause: %1</source>
        <translation>原因：%1</translation>
    </message>
    <message>
        <source>Also possible: %1</source>
        <translation>也可能是：%1</translation>
    </message>
    <message>
        <source>What to do: %1</source>
        <translation>处理方法：%1</translation>
    </message>
    <message>
        <source>The diagnosis was stopped early.</source>
        <translation>诊断已提前停止。</translation>
    </message>
    <message>
        <source>find out why a servo is not replying; writes nothing</source>
        <translation>查找舵机不应答的原因；不写入任何内容</translation>
    </message>
    <message>
        <source>other baud rates to try</source>
        <translation>另外尝试的波特率</translation>
    </message>
    <message>
        <source>Sending</source>
        <translation>正在发送</translation>
    </message>
    <message>
        <source>Recovering</source>
        <translation>正在处理未写完的更改</translation>
    </message>
    <message>
        <source>cycle %1, %2</source>
        <translation>第 %1 个循环，%2</translation>
    </message>
    <message>
        <source>Comparing with the servos</source>
        <translation>正在与舵机对比</translation>
    </message>
    <message>
        <source>write all matching entries to a CSV file instead (for other programs; without a byte order mark)</source>
        <translation>改为把所有符合条件的内容写入供程序读取的 CSV 文件（不带 BOM）</translation>
    </message>
    <message>
        <source>output as CSV, without a byte order mark</source>
        <translation>以 CSV 格式输出（不带 BOM）</translation>
    </message>
    <message>
        <source>the report file name must end with .html or .pdf</source>
        <translation>报告文件名须以 .html 或 .pdf 结尾</translation>
    </message>
    <message>
        <source>%1 contains no servos</source>
        <translation>%1 中没有舵机</translation>
    </message>
    <message>
        <source>create a report of a commissioning batch; no port is needed</source>
        <translation>生成批量设置报告；不需要端口</translation>
    </message>
    <message>
        <source>batch file (.csv)</source>
        <translation>批次文件（.csv）</translation>
    </message>
    <message>
        <source>report file: .html or .pdf</source>
        <translation>报告文件：.html 或 .pdf</translation>
    </message>
    <message>
        <source>also save the memory table as a report</source>
        <translation>同时将内存表保存为报告</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>使用中</translation>
    </message>
    <message>
        <source>Newer version known</source>
        <translation>已知的较新版本</translation>
    </message>
    <message>
        <source>differs from the others</source>
        <translation>与其他舵机不同</translation>
    </message>
    <message>
        <source>The firmware versions differ. LeRobot refuses a bus whose servos do not all have the same version.</source>
        <translation>固件版本不一致。总线上的舵机固件版本不全相同时，LeRobot 拒绝连接。</translation>
    </message>
    <message>
        <source>Newer versions are listed in the vendor&apos;s firmware catalog; they may not be the latest.</source>
        <translation>较新版本取自厂家的固件目录，不一定是最新版本。</translation>
    </message>
    <message>
        <source>list the servos&apos; firmware versions, and those that differ</source>
        <translation>列出各舵机的固件版本，标出不一致的舵机</translation>
    </message>
    <message>
        <source>no servo replied</source>
        <translation>没有舵机应答</translation>
    </message>
    <message>
        <source>possibly several servos with one ID</source>
        <translation>可能有多个舵机使用同一个 ID</translation>
    </message>
    <message>
        <source>Searching %1</source>
        <translation>正在搜索 %1</translation>
    </message>
    <message>
        <source>This computer has no serial port.</source>
        <translation>本机没有串口。</translation>
    </message>
    <message>
        <source>search all ports at all baud rates until servos reply</source>
        <translation>以所有波特率搜索所有端口，直到有舵机应答</translation>
    </message>
    <message>
        <source>only these ports</source>
        <translation>只搜索这些端口</translation>
    </message>
    <message>
        <source>search not finished</source>
        <translation>搜索未完成</translation>
    </message>
    <message>
        <source>Six new servos: all have ID 1 and reply at the same time</source>
        <translation>六个新舵机：ID 都是 1，同时应答</translation>
    </message>
    <message>
        <source>the vendor&apos;s firmware file, *.bin</source>
        <translation>厂家的固件文件，*.bin</translation>
    </message>
    <message>
        <source>--accept takes %1, or all</source>
        <translation>--accept 可以是 %1，或 all</translation>
    </message>
    <message>
        <source>Servo %1 at %2 baud: firmware %3</source>
        <translation>舵机 %1，波特率 %2：固件 %3</translation>
    </message>
    <message>
        <source>%1 of %2 blocks were accepted.</source>
        <translation>舵机接受了 %2 个数据块中的 %1 个。</translation>
    </message>
    <message>
        <source>Not started. Correct what has failed, or accept the risk with --accept ITEM.</source>
        <translation>未开始。请先解决未通过的项目，或用 --accept 项目 接受风险。</translation>
    </message>
    <message>
        <source>Updating the firmware of servo %1</source>
        <translation>正在更新舵机 %1 的固件</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>正在检查</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>详情</translation>
    </message>
    <message>
        <source>good</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>已接受风险</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>未通过</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>现在</translation>
    </message>
    <message>
        <source>Connect only the servo to rescue. Turn its supply off, then on again within the next 30 s.</source>
        <translation>只连接要救援的舵机。请在 30 秒内断开它的电源，再重新接通。</translation>
    </message>
    <message>
        <source>Waiting for a bootloader</source>
        <translation>正在等待引导程序</translation>
    </message>
    <message>
        <source>IDs of the servos, one after the other</source>
        <translation>舵机的 ID，逐个更新</translation>
    </message>
    <message>
        <source>start although these checks have failed</source>
        <translation>即使这些检查未通过也开始</translation>
    </message>
    <message>
        <source>Rescue: servodesk-cli firmware rescue &quot;%1&quot;</source>
        <translation>救援：servodesk-cli firmware rescue &quot;%1&quot;</translation>
    </message>
    <message>
        <source>To restore the old values: servodesk-cli snapshot restore %1 &quot;%2&quot;</source>
        <translation>恢复原值：servodesk-cli snapshot restore %1 &quot;%2&quot;</translation>
    </message>
    <message>
        <source>write the vendor&apos;s firmware file to Feetech servos, after checks; not tried on real servos yet</source>
        <translation>检查后，把厂家的固件文件写入飞特舵机；尚未在真实舵机上试过</translation>
    </message>
    <message>
        <source>write the vendor&apos;s firmware file to a servo that is in its bootloader; not tried on real servos yet</source>
        <translation>把厂家的固件文件写入停留在引导程序中的舵机；尚未在真实舵机上试过</translation>
    </message>
    <message>
        <source>--arm takes %1, or a file</source>
        <translation>--arm 可用 %1，或一个文件</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>位置校正</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>LeRobot&apos;s calibration file, *.json</source>
        <translation>LeRobot 的校准文件，*.json</translation>
    </message>
    <message>
        <source>LeRobot&apos;s calibration files on this computer:</source>
        <translation>本机上的 LeRobot 校准文件：</translation>
    </message>
    <message>
        <source>LeRobot would ask for a new calibration. To write the file to the servos: servodesk-cli arm apply &quot;%1&quot;; to write the servos to the file: servodesk-cli arm export &quot;%1&quot;</source>
        <translation>LeRobot 会要求重新校准。把文件写入舵机：servodesk-cli arm apply &quot;%1&quot;；把舵机的值保存到文件：servodesk-cli arm export &quot;%1&quot;</translation>
    </message>
    <message>
        <source>the file has no joint %1 with the ID %2</source>
        <translation>文件中没有 ID 为 %2 的关节 %1</translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation>已保存到 %1</translation>
    </message>
    <message>
        <source>--format takes lerobot or arm</source>
        <translation>--format 可用 lerobot 或 arm</translation>
    </message>
    <message>
        <source>list the joints of a robot arm with position, offset and limits, and what LeRobot would refuse</source>
        <translation>列出机械臂的关节及其位置、位置校正和角度限制，以及 LeRobot 会拒绝的问题</translation>
    </message>
    <message>
        <source>compare LeRobot&apos;s calibration file with the servos</source>
        <translation>将 LeRobot 的校准文件与舵机对比</translation>
    </message>
    <message>
        <source>save what the servos hold as LeRobot&apos;s calibration file</source>
        <translation>把舵机中的值保存为 LeRobot 的校准文件</translation>
    </message>
    <message>
        <source>lerobot (default): what the servos hold; arm: the joints, as a file for --arm</source>
        <translation>lerobot（默认）：舵机中的值；arm：关节列表，可用于 --arm 的文件</translation>
    </message>
    <message>
        <source>only these joints: NAME,NAME (default: all)</source>
        <translation>仅限这些关节：名称,名称（默认：全部）</translation>
    </message>
    <message>
        <source>do not ask before torque off and writing</source>
        <translation>卸力和写入前不询问</translation>
    </message>
    <message>
        <source>no joint %1; the arm has %2</source>
        <translation>没有关节 %1；机械臂有 %2</translation>
    </message>
    <message>
        <source>Press Enter when every joint has been moved.</source>
        <translation>转动完所有关节后按回车。</translation>
    </message>
    <message numerus="yes">
        <source>Press Enter to write offset and limits of %n joint(s).</source>
        <translation>
            <numerusform>按回车写入 %n 个关节的位置校正和角度限制。</numerusform>
        </translation>
    </message>
    <message>
        <source>Robot arm:</source>
        <translation>机械臂：</translation>
    </message>
    <message>
        <source>The file and the servos agree.</source>
        <translation>文件与舵机一致。</translation>
    </message>
    <message>
        <source>Torque will be turned off, so the arm drops: hold it. Press Enter to write.</source>
        <translation>即将卸力，机械臂会落下：请扶住。按回车写入。</translation>
    </message>
    <message>
        <source>recording time (default: until Enter)</source>
        <translation>采集时长（默认：直到按回车）</translation>
    </message>
    <message>
        <source>the pose at the end of the recording becomes the middle (default: the middle of each range)</source>
        <translation>以采集结束时的姿态作为中位（默认：各范围的中点）</translation>
    </message>
    <message>
        <source>Torque will be turned off, so the arm drops: hold it. Then move every joint through its whole range, in any order.</source>
        <translation>即将卸力，机械臂会落下：请扶住。然后以任意顺序把每个关节转过整个范围。</translation>
    </message>
    <message>
        <source>End with every joint in its middle position.</source>
        <translation>结束时请让每个关节处于中位。</translation>
    </message>
    <message>
        <source>Press Enter to begin.</source>
        <translation>按回车开始。</translation>
    </message>
    <message>
        <source>--yes needs --seconds</source>
        <translation>--yes 需要 --seconds</translation>
    </message>
    <message>
        <source>To see them: servodesk-cli firmware list</source>
        <translation>查看：servodesk-cli firmware list</translation>
    </message>
    <message>
        <source>To close it: servodesk-cli write ID lock=1</source>
        <translation>上锁命令：servodesk-cli write ID lock=1</translation>
    </message>
    <message>
        <source>To write them now: servodesk-cli arm prepare</source>
        <translation>现在写入：servodesk-cli arm prepare</translation>
    </message>
    <message>
        <source>the arm has no joint to move</source>
        <translation>该机械臂没有可运动的关节</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>cause, remedy</comment>
        <translation>%1%2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>write the settings that LeRobot writes at each start (mode, gains, reply delay, gripper limits); torque is turned off</source>
        <translation>写入 LeRobot 每次启动时写入的参数（模式、增益、返回延时、夹爪限制）；会卸力</translation>
    </message>
    <message>
        <source>torque limit during the test, 5–100 % (default: 30)</source>
        <translation>测试时的扭矩限制，5～100%（默认：30）</translation>
    </message>
    <message>
        <source>--torque takes 5 to 100</source>
        <translation>--torque 的取值为 5 到 100</translation>
    </message>
    <message>
        <source>%1; at %2, goal %3</source>
        <translation>%1；位置 %2，目标 %3</translation>
    </message>
    <message>
        <source>move each joint to the ends of its limits and back, slowly and with little torque, and report whether it got there</source>
        <translation>让每个关节以低速、小扭矩运动到角度限制的两端并返回，并报告是否到达</translation>
    </message>
    <message>
        <source>Something is in the way, the limits are beyond a mechanical stop, or the torque is too little (--torque). To set the limits: servodesk-cli arm calibrate</source>
        <translation>有障碍物、角度限制超出机械限位，或扭矩不足（--torque）。设置角度限制：servodesk-cli arm calibrate</translation>
    </message>
    <message>
        <source>so101 (default), so101-leader, lekiwi, six-joint, or a file with an arm</source>
        <translation>so101（默认）、so101-leader、lekiwi、six-joint，或机械臂文件</translation>
    </message>
    <message>
        <source>not known for this family</source>
        <translation>没有该系列的参数</translation>
    </message>
    <message>
        <source>do not ask before moving</source>
        <translation>运动前不询问</translation>
    </message>
    <message>
        <source>Not calibrated, so these run into their mechanical stops: %1</source>
        <translation>未校准，会撞到机械限位：%1</translation>
    </message>
    <message>
        <source>Each joint moves to the ends of its limits and back, with %1 % of its torque. Keep hands and objects away. Torque is off afterwards: hold what would drop. Press Enter to begin.</source>
        <translation>每个关节以 %1% 的扭矩运动到角度限制的两端并返回。请勿靠近，并移开障碍物。结束后为卸力状态：请扶住可能下落的部分。按回车开始。</translation>
    </message>
    <message>
        <source>describe a command</source>
        <translation>说明一个命令</translation>
    </message>
    <message>
        <source>unknown command &quot;%1&quot;; did you mean %2?</source>
        <translation>未知命令“%1”；是不是要用 %2？</translation>
    </message>
    <message>
        <source>write offsets and limits of LeRobot&apos;s calibration file to the servos, and set position mode with single-turn feedback where needed; torque is turned off</source>
        <translation>把 LeRobot 校准文件中的位置校正和角度限制写入舵机，需要时设为位置模式和单圈反馈；会卸力</translation>
    </message>
    <message>
        <source>output file; of an existing calibration file, keys of other programs are kept; an existing arm file is replaced</source>
        <translation>输出文件；已有的校准文件中，其他程序的键会保留；已有的机械臂文件会被替换</translation>
    </message>
    <message>
        <source>calibrate a robot arm by moving its joints by hand: torque off, record the ranges, write offsets and limits, and set position mode with single-turn feedback where needed</source>
        <translation>用手转动关节来校准机械臂：卸力、采集范围、写入位置校正和角度限制，需要时设为位置模式和单圈反馈</translation>
    </message>
    <message>
        <source>new ID, 0 to 253 (Modbus: 1 to 247)</source>
        <translation>新的 ID，0 到 253（Modbus：1 到 247）</translation>
    </message>
    <message>
        <source>connection string, for example postgresql://USER@HOST/DATABASE, without a password (store the password in ~/.pgpass); default: SERVODESK_HISTORY_SERVER, or else the remembered server. By default, a server on another computer needs a valid TLS certificate; to change this, use ?sslmode=...</source>
        <translation>连接字符串，例如 postgresql://USER@HOST/DATABASE，不含密码（密码存放在 ~/.pgpass）；默认：SERVODESK_HISTORY_SERVER，否则为已记住的服务器。其他计算机上的服务器默认必须有有效的 TLS 证书；如需更改，请使用 ?sslmode=...</translation>
    </message>
    <message>
        <source>use this server and name from now on, in the desktop program too; saved once everything has been sent</source>
        <translation>从现在起使用此服务器和名称，桌面程序也一样；全部发送完成后才保存</translation>
    </message>
    <message>
        <source>abandon a change whose servo will not be connected again, or all (the first characters of the change name are enough)</source>
        <translation>放弃某个更改（或全部），仅在相应舵机不会再接上时使用（写出更改名称的前几个字符即可）</translation>
    </message>
    <message>
        <source>position, position-pd, multiturn, speed, pwm, step, current, release or motor, depending on the servo family</source>
        <translation>position（位置）、position-pd（位置 PD）、multiturn（多圈）、speed（恒速）、pwm、step（步进）、current（恒流）、release（到位卸力）或 motor（电机），视系列而定</translation>
    </message>
    <message>
        <source>allow writing dangerous registers: ID, baud rate, torque, midpoint, mode, and what can make the servo unreachable, shift its positions or take its limits away</source>
        <translation>允许写入危险的参数：ID、波特率、扭矩、中位、模式，以及可能使舵机失联、位置偏移或失去角度限制的参数</translation>
    </message>
    <message>
        <source>Exit codes: 0 success, 1 not executed, failed, different or stopped, 2 usage error, 3 port error, 4 no reply, 5 file error.
&quot;servodesk-cli help COMMAND&quot; describes a command.</source>
        <translation>退出码：0 成功，1 未执行、失败、不合格、不一致或已停止，2 用法错误，3 端口错误，4 无应答，5 文件错误。
“servodesk-cli help 命令”说明某个命令。</translation>
    </message>
    <message>
        <source>number of cycles (default: 10; with --duration: unlimited)</source>
        <translation>循环次数（默认：10；给出 --duration 时不限）</translation>
    </message>
    <message>
        <source>end after the first cycle in which a servo fails a limit</source>
        <translation>某个舵机有指标不合格时，在该循环结束后停止</translation>
    </message>
    <message>
        <source>print the result as a single JSON document (commission: one line per servo)</source>
        <translation>以单个 JSON 文档输出结果（commission：每个舵机一行）</translation>
    </message>
</context>
<context>
    <name>text</name>
    <message>
        <source>the servo has no acceleration setting</source>
        <translation>舵机没有加速度参数</translation>
    </message>
    <message>
        <source>the servo has no speed setting</source>
        <translation>舵机没有速度参数</translation>
    </message>
    <message>
        <source>the servo has no damping</source>
        <translation>舵机没有阻尼功能</translation>
    </message>
    <message>
        <source>torque cannot be turned on or off on this servo</source>
        <translation>此舵机不支持打开扭矩或卸力</translation>
    </message>
    <message>
        <source>the servo does not report its position</source>
        <translation>舵机不反馈位置</translation>
    </message>
    <message>
        <source>Use set-id to change the ID.</source>
        <translation>请用 set-id 修改 ID。</translation>
    </message>
    <message>
        <source>Use set-baud to change the baud rate.</source>
        <translation>请用 set-baud 修改波特率。</translation>
    </message>
    <message>
        <source>this servo does not support a travel time in its present mode</source>
        <translation>此舵机在当前模式下不支持设定运行时间</translation>
    </message>
    <message>
        <source>time and speed cannot be combined</source>
        <translation>时间和速度不能同时给出</translation>
    </message>
    <message>
        <source>the port is in use by %1</source>
        <translation>端口正被 %1 占用</translation>
    </message>
    <message>
        <source>Changing this value safely requires more than writing one register.</source>
        <translation>要安全地完成此更改，只写一个参数是不够的。</translation>
    </message>
    <message>
        <source>port not found</source>
        <translation>找不到端口</translation>
    </message>
    <message>
        <source>the port is in use</source>
        <translation>端口被占用</translation>
    </message>
    <message>
        <source>Close the other program, or use another port.</source>
        <translation>请关闭其他程序，或换用别的端口。</translation>
    </message>
    <message>
        <source>Your account does not belong to the group that owns serial ports.</source>
        <translation>您的账户不属于串口所属的用户组。</translation>
    </message>
    <message>
        <source>Run &quot;sudo usermod -aG %1 $USER&quot;, then log in again.</source>
        <translation>请执行“sudo usermod -aG %1 $USER”，然后重新登录。</translation>
    </message>
    <message>
        <source>the port could not be opened</source>
        <translation>端口无法打开</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>interrupted by the emergency stop</source>
        <translation>操作被急停中断</translation>
    </message>
    <message>
        <source>Correct the value and try again.</source>
        <translation>请改正数值后再试。</translation>
    </message>
    <message>
        <source>This register is set by the factory or by the servo itself.</source>
        <translation>此参数由厂家或舵机自身设定。</translation>
    </message>
    <message>
        <source>Save a snapshot, then repeat the write and confirm it explicitly.</source>
        <translation>请先保存快照，再重新写入，并按提示确认。</translation>
    </message>
    <message>
        <source>file not found</source>
        <translation>找不到文件</translation>
    </message>
    <message>
        <source>Check the path.</source>
        <translation>请检查路径。</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>文件无法读取</translation>
    </message>
    <message>
        <source>Check the file permissions, or use a copy.</source>
        <translation>请检查文件权限，或换用副本。</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>文件无法写入</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>sentence, technical detail</comment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>subject: sentence</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1.</source>
        <comment>full stop</comment>
        <translation>%1。</translation>
    </message>
    <message>
        <source>servo %1</source>
        <translation>舵机 %1</translation>
    </message>
    <message>
        <source>The reply came from ID %1.</source>
        <translation>应答来自 ID %1。</translation>
    </message>
    <message>
        <source>The change takes effect at the next power-on.</source>
        <translation>此更改在下次上电后生效。</translation>
    </message>
    <message>
        <source>Stopped before %3 was written.</source>
        <translation>操作在写入 %3 之前已停止。</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>temporary</source>
        <translation>临时有效</translation>
    </message>
    <message>
        <source>mismatch</source>
        <translation>回读不符</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>被拒绝</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>RS485</source>
        <translation>RS485</translation>
    </message>
    <message>
        <source>feedback</source>
        <translation>反馈</translation>
    </message>
    <message>
        <source>factory</source>
        <translation>出厂</translation>
    </message>
    <message>
        <source>read/write</source>
        <translation>读写</translation>
    </message>
    <message>
        <source>bit %1</source>
        <translation>位 %1</translation>
    </message>
    <message>
        <source>none</source>
        <comment>alarms</comment>
        <translation>无</translation>
    </message>
    <message>
        <source>its memory table has no such register</source>
        <translation>舵机的内存表中没有这个参数</translation>
    </message>
    <message>
        <source>its protocol has no such instruction</source>
        <translation>舵机的协议没有此指令</translation>
    </message>
    <message>
        <source>Modbus addresses must be 1 to 247</source>
        <translation>Modbus 站号须为 1 到 247</translation>
    </message>
    <message>
        <source>the servo has no command for this</source>
        <translation>该舵机没有此指令</translation>
    </message>
    <message>
        <source>Write to register %1 instead.</source>
        <translation>请改为写入参数 %1。</translation>
    </message>
    <message>
        <source>Servos from different manufacturers share this bus and have the same ID.</source>
        <translation>此总线上接有不同厂家的舵机，并且 ID 相同。</translation>
    </message>
    <message>
        <source>Whether %3 is kept after power-off is not documented.</source>
        <translation>资料未说明 %3 断电后是否保存。</translation>
    </message>
    <message>
        <source>%3 is 0, so no current is allowed and the servo has no torque.</source>
        <translation>%3 为 0，即不允许有电流，因此舵机没有扭矩。</translation>
    </message>
    <message>
        <source>ServoDesk detected that the temperature is above its limit; the servo did not report this.</source>
        <translation>温度超过上限（由 ServoDesk 判断，并非舵机报告）。</translation>
    </message>
    <message>
        <source>ServoDesk detected that the voltage is outside its limits; the servo did not report this.</source>
        <translation>电压超出限值（由 ServoDesk 判断，并非舵机报告）。</translation>
    </message>
    <message>
        <source>the baud rate cannot be changed</source>
        <translation>波特率不能修改</translation>
    </message>
    <message>
        <source>This family has no such command.</source>
        <translation>该系列没有这种指令。</translation>
    </message>
    <message>
        <source>Write the default values one by one.</source>
        <translation>请逐个写入出厂默认值。</translation>
    </message>
    <message>
        <source>This family has no packet that addresses several servos.</source>
        <translation>该系列没有可同时写入多个舵机的数据包。</translation>
    </message>
    <message>
        <source>Keep clear of the mechanism, then repeat the write and confirm it explicitly.</source>
        <translation>请远离机构，再重新写入，并按提示确认。</translation>
    </message>
    <message>
        <source>not reported</source>
        <comment>alarms</comment>
        <translation>不上报</translation>
    </message>
    <message>
        <source>overload</source>
        <translation>过载</translation>
    </message>
    <message>
        <source>overcurrent</source>
        <translation>过流</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>过压欠压</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>过温</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>the alarm has changed since you confirmed clearing it</source>
        <translation>您确认解除报警后，报警已发生变化</translation>
    </message>
    <message>
        <source>the servo is not in a position mode</source>
        <translation>舵机不在位置模式</translation>
    </message>
    <message>
        <source>the step is 0</source>
        <translation>步长为 0</translation>
    </message>
    <message>
        <source>the delay is 0</source>
        <translation>延时为 0</translation>
    </message>
    <message>
        <source>the test would never end</source>
        <translation>按此设置，测试永远不会结束</translation>
    </message>
    <message>
        <source>Use the memory table to write other registers.</source>
        <translation>其他参数请在内存表中写入。</translation>
    </message>
    <message>
        <source>the history was written by a newer version of this program</source>
        <translation>历史记录是由本程序的较新版本写入的</translation>
    </message>
    <message>
        <source>Close other programs that have history.sqlite open, and try again.</source>
        <translation>请关闭打开了 history.sqlite 的其他程序，然后重试。</translation>
    </message>
    <message>
        <source>the history database is damaged</source>
        <translation>历史记录数据库已损坏</translation>
    </message>
    <message>
        <source>the history cannot be written</source>
        <translation>历史记录无法写入</translation>
    </message>
    <message>
        <source>Choose a later time.</source>
        <translation>请选择较晚的时间。</translation>
    </message>
    <message>
        <source>Set by the factory or by the servo itself.</source>
        <translation>由厂家或舵机自身设定。</translation>
    </message>
    <message>
        <source>factory value</source>
        <translation>出厂值</translation>
    </message>
    <message>
        <source>dangerous: requires confirmation</source>
        <translation>危险：需要确认</translation>
    </message>
    <message>
        <source>this servo has no such register</source>
        <translation>此舵机没有该参数</translation>
    </message>
    <message>
        <source>not in the file</source>
        <translation>文件中没有</translation>
    </message>
    <message>
        <source>no value in the file</source>
        <translation>文件中没有该参数的值</translation>
    </message>
    <message>
        <source>could not be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>outside this model&apos;s range</source>
        <translation>数值超出此型号的范围</translation>
    </message>
    <message>
        <source>converted to this servo&apos;s steps</source>
        <translation>已换算为此舵机的步数</translation>
    </message>
    <message>
        <source>The physical value is the same; only the raw number differs.</source>
        <translation>物理值相同，原始值不同。</translation>
    </message>
    <message>
        <source>write and read back</source>
        <translation>写入并回读</translation>
    </message>
    <message>
        <source>change the ID</source>
        <translation>修改 ID</translation>
    </message>
    <message>
        <source>change the baud rate</source>
        <translation>修改波特率</translation>
    </message>
    <message>
        <source>nothing to write</source>
        <translation>无需写入</translation>
    </message>
    <message>
        <source>restored</source>
        <translation>已恢复</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>would be written</source>
        <translation>将会写入</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>无法执行</translation>
    </message>
    <message>
        <source>different</source>
        <translation>不同</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺少</translation>
    </message>
    <message>
        <source>identical</source>
        <translation>相同</translation>
    </message>
    <message>
        <source>read-only</source>
        <translation>只读</translation>
    </message>
    <message>
        <source>the history server cannot be reached</source>
        <translation>无法连接历史记录服务器</translation>
    </message>
    <message>
        <source>The password is wrong or missing, or there is no such user.</source>
        <translation>密码错误或缺失，或没有该用户。</translation>
    </message>
    <message>
        <source>the history server has no such database</source>
        <translation>历史记录服务器上没有该数据库</translation>
    </message>
    <message>
        <source>the database on the history server is from a newer version of this program</source>
        <translation>历史记录服务器上的数据库来自本程序的较新版本</translation>
    </message>
    <message>
        <source>the database on the history server is from an older version of this program</source>
        <translation>历史记录服务器上的数据库来自本程序的较旧版本</translation>
    </message>
    <message>
        <source>The encoding of the database is not UTF8.</source>
        <translation>数据库的编码不是 UTF8。</translation>
    </message>
    <message>
        <source>the history server is too busy</source>
        <translation>历史记录服务器太忙</translation>
    </message>
    <message>
        <source>the disk of the history server is full</source>
        <translation>历史记录服务器的磁盘已满</translation>
    </message>
    <message>
        <source>the history server reports an error</source>
        <translation>历史记录服务器报告错误</translation>
    </message>
    <message>
        <source>Check the user in the connection string, and the password in ~/.pgpass (a line HOST:PORT:DATABASE:USER:PASSWORD, file mode 0600).</source>
        <translation>请检查连接字符串中的用户名，以及 ~/.pgpass 中的密码（格式为一行 HOST:PORT:DATABASE:USER:PASSWORD，文件权限 0600）。</translation>
    </message>
    <message>
        <source>the history server and this computer cannot agree on encryption</source>
        <translation>历史记录服务器与本机无法就加密方式达成一致</translation>
    </message>
    <message>
        <source>One side requires TLS and the other does not offer it. By default, servers on other computers must use TLS (sslmode=verify-full).</source>
        <translation>一方要求 TLS，而另一方不支持。其他计算机上的服务器默认必须使用 TLS（sslmode=verify-full）。</translation>
    </message>
    <message>
        <source>Enable TLS on the server (ssl = on). On a trusted network, you can use sslmode=disable in the connection string instead; all data is then sent unencrypted.</source>
        <translation>请在服务器上启用 TLS（ssl = on）。在可信网络中，也可改为在连接字符串中写 sslmode=disable，此时所有数据不加密传输。</translation>
    </message>
    <message>
        <source>the certificate of the history server cannot be verified</source>
        <translation>无法验证历史记录服务器的证书</translation>
    </message>
    <message>
        <source>Save the certificate of the issuing authority as ~/.postgresql/root.crt, or specify the certificate file with sslrootcert=FILE in the connection string. sslmode=require encrypts without verification.</source>
        <translation>请将签发机构的证书保存为 ~/.postgresql/root.crt，或在连接字符串中用 sslrootcert=FILE 指定其文件。sslmode=require 只加密而不验证。</translation>
    </message>
    <message>
        <source>the certificate of the history server is for another host name</source>
        <translation>历史记录服务器的证书与主机名不符</translation>
    </message>
    <message>
        <source>the connection string contains a password</source>
        <translation>连接字符串中含有密码</translation>
    </message>
    <message>
        <source>Remove the password from the string and store it in ~/.pgpass: a line HOST:PORT:DATABASE:USER:PASSWORD, file mode 0600.</source>
        <translation>请从连接字符串中删除密码，并将其存放在 ~/.pgpass 中：格式为一行 HOST:PORT:DATABASE:USER:PASSWORD，文件权限 0600。</translation>
    </message>
    <message>
        <source>limit from a different model</source>
        <translation>其他型号的限值</translation>
    </message>
    <message>
        <source>would cause an alarm now</source>
        <translation>写入会立即引起报警</translation>
    </message>
    <message>
        <source>this test did not finish, so it cannot be a reference</source>
        <translation>此测试未完成，不能设为参考</translation>
    </message>
    <message>
        <source>the step is negative</source>
        <translation>步长为负</translation>
    </message>
    <message>
        <source>the servo family is unclear</source>
        <translation>舵机系列不明</translation>
    </message>
    <message>
        <source>not in the model list</source>
        <translation>不在型号表中</translation>
    </message>
    <message>
        <source>%1, byte order flag %2</source>
        <translation>%1，字节序标志 %2</translation>
    </message>
    <message>
        <source>the servo family is unclear: firmware %1, byte order flag %2 and model number %3 contradict each other</source>
        <translation>舵机系列不明：固件 %1、字节序标志 %2 与型号编号 %3 互相矛盾</translation>
    </message>
    <message>
        <source>not sent</source>
        <translation>未发送</translation>
    </message>
    <message>
        <source>%1 (servos %2)</source>
        <comment>what, IDs</comment>
        <translation>%1（舵机 %2）</translation>
    </message>
    <message>
        <source>this servo failed the test, so it cannot be a reference</source>
        <translation>该舵机测试不合格，不能设为参考</translation>
    </message>
    <message>
        <source>Choose a servo that passed.</source>
        <translation>请选择一个合格的舵机。</translation>
    </message>
    <message>
        <source>the connection string contains a parameter that is not accepted</source>
        <translation>连接字符串中含有不接受的参数</translation>
    </message>
    <message>
        <source>Use only host, hostaddr, port, dbname, user, service, connect_timeout, application_name, target_session_attrs and parameters that begin with ssl, gss or keepalives.</source>
        <translation>只能使用 host、hostaddr、port、dbname、user、service、connect_timeout、application_name、target_session_attrs，以及以 ssl、gss 或 keepalives 开头的参数。</translation>
    </message>
    <message>
        <source>Port → Interrupted writes</source>
        <translation>“端口 → 未写完的更改”</translation>
    </message>
    <message>
        <source>recover</source>
        <comment>command</comment>
        <translation>“recover”</translation>
    </message>
    <message>
        <source>The load was above its threshold for too long. Possible causes: a stall, a jammed bracket, or more load than the servo is rated for. The servo now provides only the protection torque.</source>
        <translation>负载超过阈值的时间过长。可能的原因：堵转、支架卡死，或所需扭矩超过额定值。舵机现在只输出保护扭矩。</translation>
    </message>
    <message>
        <source>The current was above its threshold for too long. Possible causes: a stall or a short circuit. The servo has turned its torque off.</source>
        <translation>电流超过阈值的时间过长。可能的原因：堵转或短路。舵机已自动卸力。</translation>
    </message>
    <message>
        <source>The supply voltage is outside the servo&apos;s limits. Possible causes: the wrong power supply, a power supply that is too weak, or thin wires that cause a voltage drop under load.</source>
        <translation>供电电压超出舵机限值。可能的原因：电源不匹配、功率不足，或导线太细，带载时压降过大。</translation>
    </message>
    <message>
        <source>The servo has exceeded its temperature limit. Possible causes: a prolonged load, a stall, poor cooling, or a limit that is set too low. Remove the load and let the servo cool down.</source>
        <translation>舵机温度超过上限。可能的原因：长时间负载、堵转、散热差，或温度上限设得太低。请去除负载，等待舵机冷却。</translation>
    </message>
    <message>
        <source>The magnet, the encoder or a cable inside the servo is faulty. If the alarm returns after a power cycle, the servo needs repair.</source>
        <translation>磁铁、编码器或舵机内部连线有故障。如果重新上电后仍然报警，舵机需要返修。</translation>
    </message>
    <message>
        <source>No alarms.</source>
        <translation>没有报警。</translation>
    </message>
    <message>
        <source>Setting a goal slightly back from the stalled position clears this alarm: the shaft turns back a little and holds that position.</source>
        <translation>从堵转位置往回一点设定目标，即可解除此报警：输出轴往回转一点，并保持在那里。</translation>
    </message>
    <message>
        <source>Setting a new goal at the present position clears this alarm: torque is turned on, and the servo holds that position.</source>
        <translation>把当前位置设为新目标，即可解除此报警：舵机打开扭矩并保持在该位置。</translation>
    </message>
    <message>
        <source>Writing to the fault reset register clears this alarm. The servo is first set to hold its position.</source>
        <translation>写入故障复位参数即可解除此报警。写入之前，会先让舵机保持在当前位置。</translation>
    </message>
    <message>
        <source>This alarm clears when the value is back within its limits. Nothing is written.</source>
        <translation>数值回到限值之内后，此报警自动解除。程序不写入任何内容。</translation>
    </message>
    <message>
        <source>Only turning the servo off and on clears this alarm.</source>
        <translation>只有断电后重新上电才能解除此报警。</translation>
    </message>
    <message>
        <source>The meaning of this status bit is not documented. Try turning the servo off and on.</source>
        <translation>资料未说明此状态位的含义。请尝试断电后重新上电。</translation>
    </message>
    <message>
        <source>specified twice</source>
        <translation>重复指定</translation>
    </message>
    <message>
        <source>its operating mode is unknown</source>
        <translation>舵机的运行模式未知</translation>
    </message>
    <message>
        <source>the servo did not accept the value of an earlier register</source>
        <translation>舵机没有接受前面一个参数的数值</translation>
    </message>
    <message>
        <source>ServoDesk cannot switch the baud rate through a TCP bridge</source>
        <translation>ServoDesk 无法经 TCP 网桥切换波特率</translation>
    </message>
    <message>
        <source>its reply cannot be decoded</source>
        <translation>舵机的应答无法解析</translation>
    </message>
    <message>
        <source>exception 1: function not supported</source>
        <translation>异常 1：不支持该功能码</translation>
    </message>
    <message>
        <source>exception 2: no such register</source>
        <translation>异常 2：没有该寄存器</translation>
    </message>
    <message>
        <source>exception 3: value or length not accepted</source>
        <translation>异常 3：不接受该数值或长度</translation>
    </message>
    <message>
        <source>IDs must be 0 to 253, and baud rates must be above 0</source>
        <translation>ID 须为 0 到 253，波特率须大于 0</translation>
    </message>
    <message>
        <source>no port specified</source>
        <translation>没有指定端口</translation>
    </message>
    <message>
        <source>Use the center command to set the midpoint.</source>
        <translation>请用 center 命令设为中位。</translation>
    </message>
    <message>
        <source>Use the torque command to turn torque on or off. When torque is turned on, the servo holds its present position.</source>
        <translation>请用 torque 命令打开扭矩或卸力；打开扭矩后，舵机保持在当前位置。</translation>
    </message>
    <message>
        <source>Each write automatically unlocks the EPROM and locks it again.</source>
        <translation>每次写入都会自动给 EPROM 解锁并重新上锁，无需手动操作。</translation>
    </message>
    <message>
        <source>this register cannot be written directly</source>
        <translation>此参数不能直接写入</translation>
    </message>
    <message>
        <source>in this mode, the goal needs a unit (%1)</source>
        <translation>此模式下目标必须带单位（%1）</translation>
    </message>
    <message>
        <source>not written: the servo has %1 instead of the expected %2; the new value would have been %3</source>
        <translation>未写入：舵机当前值为 %1，而不是预期的 %2；新值本应为 %3</translation>
    </message>
    <message>
        <source>the servo did not stop in time</source>
        <translation>舵机没有在规定时间内停下来</translation>
    </message>
    <message>
        <source>the servo stopped %1 steps from its goal</source>
        <translation>舵机停在离目标 %1 步处</translation>
    </message>
    <message>
        <source>no reply from this ID, but ID %1 replied</source>
        <translation>此 ID 无应答，但 ID %1 有应答</translation>
    </message>
    <message>
        <source>a different servo is replying with this ID: %1</source>
        <translation>以此 ID 应答的是另一个舵机：%1</translation>
    </message>
    <message>
        <source>the present position is outside the servo&apos;s limits (%1)</source>
        <translation>舵机的当前位置超出限制（%1）</translation>
    </message>
    <message>
        <source>the braille service (brltty) has taken over the adapter (%1)</source>
        <translation>盲文服务（brltty）占用了适配器（%1）</translation>
    </message>
    <message>
        <source>only members of the group %1 can open the port</source>
        <translation>只有用户组 %1 可以打开此端口</translation>
    </message>
    <message>
        <source>To hold its present position, the servo would need a goal outside its limits.</source>
        <translation>要让舵机保持在当前位置，目标位置就必须超出限制。</translation>
    </message>
    <message>
        <source>The servo replies with an ID other than its own, or another program is using the bus.</source>
        <translation>舵机用另一个 ID 应答，或有另一个程序在使用总线。</translation>
    </message>
    <message>
        <source>Another program has changed the value, or the servo was replaced by one of the same model.</source>
        <translation>此后有其他程序改动了该值，或舵机已换成同型号的另一个。</translation>
    </message>
    <message>
        <source>The service mistakes an adapter with this chip for a braille display, and the adapter&apos;s port disappears.</source>
        <translation>该服务把采用这种芯片的适配器当作盲文显示器，端口因此消失。</translation>
    </message>
    <message>
        <source>Turn the shaft back into its range by hand, or send a goal within the limits.</source>
        <translation>请用手将输出轴转回范围内，或设定一个范围内的目标位置。</translation>
    </message>
    <message>
        <source>Close other programs that use the bus, connect only this servo, and search for it.</source>
        <translation>请关闭使用总线的其他程序，只连接这个舵机，然后搜索该舵机。</translation>
    </message>
    <message>
        <source>If you need the value %1, set it in the memory table; this undo or redo is no longer available.</source>
        <translation>如果需要数值 %1，请在内存表中写入；此次撤销或重做已不再可用。</translation>
    </message>
    <message>
        <source>If braille is not used on this computer, run &quot;sudo apt remove brltty&quot;, then plug the adapter in again.</source>
        <translation>若本机不使用盲文，请运行“sudo apt remove brltty”，然后重新插入适配器。</translation>
    </message>
    <message>
        <source>Use a speed instead of a time.</source>
        <translation>请改用速度参数。</translation>
    </message>
    <message>
        <source>The adapter is not plugged in, its cable has no data lines, or the name is misspelled.</source>
        <translation>适配器没有插好、USB 线只能供电，或端口名写错。</translation>
    </message>
    <message>
        <source>Plug the adapter in, use a data cable, and check the list of ports.</source>
        <translation>请插好适配器，换用数据线，再查看端口列表。</translation>
    </message>
    <message>
        <source>Another program has opened the port. Two programs on one bus would receive each other&apos;s replies.</source>
        <translation>其他程序已打开此端口；两个程序共用总线会收到彼此的应答。</translation>
    </message>
    <message>
        <source>no permission to open the port</source>
        <translation>没有权限打开端口</translation>
    </message>
    <message>
        <source>The system refused access, or the other side did not accept the connection.</source>
        <translation>系统拒绝访问，或对方没有接受连接。</translation>
    </message>
    <message>
        <source>Unplug the adapter and plug it in again; for tcp://, check the host and port.</source>
        <translation>请重新插拔适配器；如果使用 tcp://，请核对主机和端口号。</translation>
    </message>
    <message>
        <source>this adapter does not support that baud rate</source>
        <translation>此适配器不支持该波特率</translation>
    </message>
    <message>
        <source>The adapter&apos;s chip or driver supports only some baud rates.</source>
        <translation>适配器的芯片或驱动只支持部分波特率。</translation>
    </message>
    <message>
        <source>Use another baud rate or another adapter.</source>
        <translation>请换用其他波特率或其他适配器。</translation>
    </message>
    <message>
        <source>the connection was lost</source>
        <translation>连接中断</translation>
    </message>
    <message>
        <source>The adapter was unplugged or lost power, or the other side closed the connection.</source>
        <translation>适配器被拔掉、断电，或对方关闭了连接。</translation>
    </message>
    <message>
        <source>Plug the adapter in again. If a change was in progress, check the interrupted writes (%recover) before you continue.</source>
        <translation>请重新插好适配器。如果正在修改参数，请先查看未写完的更改（%recover），再继续操作。</translation>
    </message>
    <message>
        <source>The servo has no power, a wire is loose, or the ID, baud rate or protocol does not match.</source>
        <translation>舵机未供电、接线松动，或 ID、波特率、协议不对。</translation>
    </message>
    <message>
        <source>Measure the voltage at the servo, check the wires, and search at all baud rates.</source>
        <translation>请测量舵机端电压，检查接线，并以所有波特率搜索。</translation>
    </message>
    <message>
        <source>the reply could not be decoded</source>
        <translation>应答无法解析</translation>
    </message>
    <message>
        <source>Possible causes: two servos with the same ID, a wrong baud rate, noise, long wires or no common ground.</source>
        <translation>可能的原因：ID 重复、波特率不对、干扰、线太长或未共地。</translation>
    </message>
    <message>
        <source>Connect only this servo, check the ground wire, and search at all baud rates.</source>
        <translation>请只接这一个舵机，检查地线，并以所有波特率搜索。</translation>
    </message>
    <message>
        <source>the reply does not match the request</source>
        <translation>应答与请求不符</translation>
    </message>
    <message>
        <source>Another program or controller is using the bus, or two servos have the same ID.</source>
        <translation>有另一个程序或主机在使用总线，或 ID 重复。</translation>
    </message>
    <message>
        <source>Close other programs that use the bus, and connect only this servo.</source>
        <translation>请关闭使用总线的其他程序，只接这一个舵机。</translation>
    </message>
    <message>
        <source>the bus is never idle: a device is sending continuously</source>
        <translation>总线一直没有空闲：有设备在不停地发送数据</translation>
    </message>
    <message>
        <source>Possible causes: a device that sends data on its own, a second controller on the bus, an adapter or bridge used for something else, or noise on an open line.</source>
        <translation>可能的原因：有设备主动发送数据、总线上有另一个主机、适配器或网桥被用于其他用途，或线路悬空引入噪声。</translation>
    </message>
    <message>
        <source>Connect only one servo, check the wires, and select the right port.</source>
        <translation>请只连接一个舵机，检查连线，并选择正确的端口。</translation>
    </message>
    <message>
        <source>no acknowledgment received, so it is unknown whether the servo executed the request</source>
        <translation>没有收到应答，不能确定舵机是否已执行请求</translation>
    </message>
    <message>
        <source>Possible causes: noise on the line or a voltage drop. Do not repeat this request without checking the servo.</source>
        <translation>可能的原因：线路受干扰或电压跌落。检查舵机之前，请勿重发此请求。</translation>
    </message>
    <message>
        <source>Read the servo&apos;s state first, then decide whether to repeat the request.</source>
        <translation>请先读取舵机状态，再决定是否重发请求。</translation>
    </message>
    <message>
        <source>You stopped the operation.</source>
        <translation>您已停止该操作。</translation>
    </message>
    <message>
        <source>Start again when you are ready; the remaining steps were not executed.</source>
        <translation>准备好后可重新开始；剩余步骤没有执行。</translation>
    </message>
    <message>
        <source>Torque was turned off on the whole bus.</source>
        <translation>总线上的所有舵机已卸力。</translation>
    </message>
    <message>
        <source>Make sure that nothing can move unexpectedly, then start again.</source>
        <translation>请确认没有部件会意外运动，然后重新开始。</translation>
    </message>
    <message>
        <source>another task is using this servo</source>
        <translation>此舵机正被另一项任务占用</translation>
    </message>
    <message>
        <source>A change in progress must not be interrupted.</source>
        <translation>正在修改参数，不能中断。</translation>
    </message>
    <message>
        <source>Wait until the task ends, or stop it.</source>
        <translation>请等任务结束，或先停止任务。</translation>
    </message>
    <message>
        <source>invalid input</source>
        <translation>输入无效</translation>
    </message>
    <message>
        <source>A value is malformed or missing, or it contradicts another value.</source>
        <translation>数值格式不对、缺失，或与其他数值矛盾。</translation>
    </message>
    <message>
        <source>this servo has no register with that name</source>
        <translation>此舵机没有使用此键名的参数</translation>
    </message>
    <message>
        <source>The name is misspelled or belongs to another family.</source>
        <translation>键名写错，或属于其他系列。</translation>
    </message>
    <message>
        <source>Look up the name in the servo&apos;s memory table.</source>
        <translation>请在舵机内存表中查找键名。</translation>
    </message>
    <message>
        <source>this register is read-only</source>
        <translation>此参数只读</translation>
    </message>
    <message>
        <source>Select a register that the memory table shows as read/write.</source>
        <translation>请选择内存表中标为“读写”的参数。</translation>
    </message>
    <message>
        <source>the value is outside the allowed range</source>
        <translation>数值超出允许范围</translation>
    </message>
    <message>
        <source>The register&apos;s range or the servo&apos;s angle limits do not allow this value.</source>
        <translation>数值超出参数范围或舵机的角度限制。</translation>
    </message>
    <message>
        <source>Use a value within the range, or change the limits first.</source>
        <translation>请使用范围内的数值，或先修改限制。</translation>
    </message>
    <message>
        <source>writing to this register can make the servo unreachable or dangerous</source>
        <translation>写入此参数可能使舵机失联或造成危险</translation>
    </message>
    <message>
        <source>this servo does not support this operation</source>
        <translation>此舵机不支持该操作</translation>
    </message>
    <message>
        <source>The servo&apos;s family, firmware or present mode does not support this function.</source>
        <translation>舵机的系列、固件或当前模式没有这项功能。</translation>
    </message>
    <message>
        <source>Check the servo&apos;s model and mode, and use only functions that it supports.</source>
        <translation>请查看舵机的型号和模式，只使用该舵机支持的功能。</translation>
    </message>
    <message>
        <source>another servo already has this ID</source>
        <translation>该 ID 已被另一个舵机使用</translation>
    </message>
    <message>
        <source>Two servos with the same ID reply at the same time, and their replies collide.</source>
        <translation>两个 ID 相同的舵机会同时应答，互相干扰。</translation>
    </message>
    <message>
        <source>Choose a free ID, or change the ID of the other servo first.</source>
        <translation>请换一个空闲的 ID，或先修改另一个舵机的 ID。</translation>
    </message>
    <message>
        <source>the servo did not execute the request</source>
        <translation>舵机没有执行请求</translation>
    </message>
    <message>
        <source>The firmware did not accept the request, the servo&apos;s protection has tripped, or the movement is blocked.</source>
        <translation>固件不接受该请求、舵机已进入保护状态，或输出轴被卡住。</translation>
    </message>
    <message>
        <source>Check the servo&apos;s status and mode, remove the cause, and try again.</source>
        <translation>请查看舵机状态和模式，排除原因后再试。</translation>
    </message>
    <message>
        <source>the value read back differs from the value written</source>
        <translation>回读的数值与写入的数值不同</translation>
    </message>
    <message>
        <source>The firmware limits the value, or another program also wrote to the servo.</source>
        <translation>固件限制了该数值，或有另一个程序也在写入此舵机。</translation>
    </message>
    <message>
        <source>Read the register again, and use a value that the servo accepts.</source>
        <translation>请重新读取参数，换用舵机接受的数值。</translation>
    </message>
    <message>
        <source>the EPROM lock could not be confirmed</source>
        <translation>无法确认 EPROM 已上锁</translation>
    </message>
    <message>
        <source>The connection failed during a change.</source>
        <translation>修改过程中连接失败。</translation>
    </message>
    <message>
        <source>Restore the connection and finish or undo the change (%recover); turning the servo off and on also locks the EPROM.</source>
        <translation>请恢复连接，然后完成或撤销更改（%recover）；舵机断电再上电后，EPROM 也会上锁。</translation>
    </message>
    <message>
        <source>no memory table matches this servo</source>
        <translation>没有适用于此舵机的内存表</translation>
    </message>
    <message>
        <source>The firmware version does not belong to any known family, so writing could cause damage.</source>
        <translation>固件版本不属于任何已知系列，写入可能造成损坏。</translation>
    </message>
    <message>
        <source>Read only the servo&apos;s feedback, or add a model file for the servo.</source>
        <translation>请仅读取舵机的反馈，或为该舵机添加型号文件。</translation>
    </message>
    <message>
        <source>The servo is a variant that is not in the model list, or its identity data is damaged. This data determines the memory table; with the wrong table, a write would change a different register, so nothing is written.</source>
        <translation>该舵机是型号表未收录的变型，或其身份数据已损坏。内存表由身份数据决定；如果内存表不对，写入会改动别的参数，因此不写入任何内容。</translation>
    </message>
    <message>
        <source>Connect only this servo and read it again. If the values stay the same, check the label on the servo. Then add a model file with this model number and the servo&apos;s actual family.</source>
        <translation>请单独连接该舵机并重新读取。若数值不变，请核对舵机标签，再添加型号文件，写明此型号编号和舵机的实际系列。</translation>
    </message>
    <message>
        <source>two servos reply with this ID</source>
        <translation>有两个舵机用该 ID 应答</translation>
    </message>
    <message>
        <source>Two servos with the same ID are connected. A write would change both, but only one of the old values would be recorded.</source>
        <translation>总线上接有两个 ID 相同的舵机。写入会同时改动两个舵机，但只会记录其中一个的原值。</translation>
    </message>
    <message>
        <source>Connect one servo at a time and change its ID. If only this servo is connected, check the wires and the ground, then try again; the check for duplicate IDs is repeated each time. A torque-off command still reaches both servos.</source>
        <translation>请逐个单独连接舵机并更改其 ID。如果总线上确实只有这一个舵机，请检查信号线和地线后重试，重试时会重新检查 ID 是否重复。卸力指令对两个舵机都有效。</translation>
    </message>
    <message>
        <source>a different servo is replying with this ID</source>
        <translation>以此 ID 应答的是另一个舵机</translation>
    </message>
    <message>
        <source>The servo was replaced, or its ID was changed.</source>
        <translation>舵机已被更换，或 ID 已被修改。</translation>
    </message>
    <message>
        <source>Connect the original servo, then try again.</source>
        <translation>请接上原来的舵机后再试。</translation>
    </message>
    <message>
        <source>the turn count of this servo is unknown</source>
        <translation>此舵机的圈数未知</translation>
    </message>
    <message>
        <source>A multi-turn servo loses its turn count at power-off, and this one reports only the position within one turn.</source>
        <translation>多圈舵机断电后圈数丢失，而此舵机只反馈单圈位置。</translation>
    </message>
    <message>
        <source>Send a goal that moves the servo to a known position, or home the axis first.</source>
        <translation>请自行设定目标，让舵机转到已知位置，或先将该轴重新回零。</translation>
    </message>
    <message>
        <source>this ID replies in more than one protocol</source>
        <translation>此 ID 在多种协议下都有应答</translation>
    </message>
    <message>
        <source>Select a protocol with --protocol, or change the ID of one of the servos.</source>
        <translation>请用 --protocol 指明协议，或修改其中一个舵机的 ID。</translation>
    </message>
    <message>
        <source>The name is misspelled, or the file was moved.</source>
        <translation>文件名写错，或文件已被移走。</translation>
    </message>
    <message>
        <source>You do not have permission to read the file, or the disk reports an error.</source>
        <translation>没有读取权限，或磁盘出错。</translation>
    </message>
    <message>
        <source>the file content is not valid</source>
        <translation>文件内容无效</translation>
    </message>
    <message>
        <source>The file is damaged, truncated, or not the expected type of file.</source>
        <translation>文件损坏、不完整，或类型不对。</translation>
    </message>
    <message>
        <source>Use an undamaged copy, or create the file again.</source>
        <translation>请换用完好的副本，或重新生成文件。</translation>
    </message>
    <message>
        <source>The folder is missing or read-only, or belongs to another user.</source>
        <translation>文件夹不存在、只读，或属于其他用户。</translation>
    </message>
    <message>
        <source>Choose a folder you can write to.</source>
        <translation>请选择有写入权限的文件夹。</translation>
    </message>
    <message>
        <source>There is no space left, or your quota is used up.</source>
        <translation>磁盘没有剩余空间，或配额已用完。</translation>
    </message>
    <message>
        <source>Free up some space, then try again.</source>
        <translation>请腾出磁盘空间后再试。</translation>
    </message>
    <message>
        <source>, %1 attempts</source>
        <translation>，已试 %1 次</translation>
    </message>
    <message>
        <source>If an adapter with a CH340 chip (1a86:7523) disappears right after it is plugged in, the braille service has taken it over: run &quot;sudo apt remove brltty&quot;.</source>
        <translation>如果 CH340 适配器（1a86:7523）插上后立即消失，说明适配器被盲文服务占用了：请运行“sudo apt remove brltty”。</translation>
    </message>
    <message>
        <source>%1 A torque-off command was sent anyway, but its effect is not confirmed.</source>
        <translation>%1仍发送了卸力指令，但无法确认其已生效。</translation>
    </message>
    <message>
        <source>the servo family is unclear: according to firmware %1, byte order flag %2 and model number %3, the EPROM lock is at address %4, but the byte at that address is %5</source>
        <translation>舵机系列不明：按固件 %1、字节序标志 %2 和型号编号 %3，EPROM 锁应在地址 %4，但该地址的值为 %5</translation>
    </message>
    <message>
        <source>two servos reply with this ID: one request got two replies</source>
        <translation>有两个舵机用该 ID 应答：一次请求收到两个应答</translation>
    </message>
    <message>
        <source>two servos reply with this ID: the replies to one request cannot come from a single servo</source>
        <translation>有两个舵机用该 ID 应答：同一请求的应答不可能出自一个舵机</translation>
    </message>
    <message>
        <source>two servos seem to reply with this ID: %1 of %2 replies could not be decoded</source>
        <translation>可能有两个舵机用该 ID 应答：%2 个应答中有 %1 个无法解析</translation>
    </message>
    <message>
        <source>The replies of two servos collide; noise on the line can look the same. A write would change both servos, but only one of the old values would be recorded.</source>
        <translation>两个舵机的应答互相冲突；线路受干扰时也可能出现同样的现象。写入会同时改动两个舵机，但只会记录其中一个的原值。</translation>
    </message>
    <message>
        <source>Turn the servo off and on, and read it again. If the byte is still neither 0 nor 1, do not write to this servo: ask the vendor for its memory table.</source>
        <translation>请给舵机断电再上电，然后重新读取。若该字节仍不是 0 或 1，请勿写入该舵机，并向厂家索取其内存表。</translation>
    </message>
    <message>
        <source>This version of ServoDesk is too old to record changes in the history, so nothing is written to the servo.</source>
        <translation>此版本的 ServoDesk 过旧，无法把更改记入该历史记录，因此不向舵机写入任何内容。</translation>
    </message>
    <message>
        <source>Use the newer version or another data folder (SERVODESK_DATA_DIR).</source>
        <translation>请使用较新的版本，或另一个数据文件夹（SERVODESK_DATA_DIR）。</translation>
    </message>
    <message>
        <source>the history has been locked for too long</source>
        <translation>历史记录被占用过久</translation>
    </message>
    <message>
        <source>Another program has locked the history, or the history is on a network drive that does not respond. Without the history, nothing is written to the servo.</source>
        <translation>另一个程序一直锁着历史记录，或者历史记录所在的网络盘没有响应。历史记录不可用时，不向舵机写入任何内容。</translation>
    </message>
    <message>
        <source>The file on the disk is incomplete, or it is not a history file. Without the history, nothing is written to the servo.</source>
        <translation>磁盘上的文件不完整，或者不是历史记录文件。历史记录不可用时，不向舵机写入任何内容。</translation>
    </message>
    <message>
        <source>Close the program and move history.sqlite, together with history.sqlite-wal and history.sqlite-shm, to a safe place; a new history is created. &quot;sqlite3 history.sqlite .recover&quot; recovers what is still readable in the old file.</source>
        <translation>请关闭本程序，把 history.sqlite 连同 history.sqlite-wal 和 -shm 移到安全的地方；程序会建立新的历史记录。“sqlite3 history.sqlite .recover”可取出旧历史记录中还能读的内容。</translation>
    </message>
    <message>
        <source>The history file or its folder is read-only or belongs to another user. Without the history, nothing is written to the servo.</source>
        <translation>历史记录文件或其文件夹是只读的，或属于其他用户。历史记录不可用时，不向舵机写入任何内容。</translation>
    </message>
    <message>
        <source>Get write permission for the file and its folder, or use another data folder (SERVODESK_DATA_DIR).</source>
        <translation>请取得该文件及其文件夹的写权限，或使用另一个数据文件夹（SERVODESK_DATA_DIR）。</translation>
    </message>
    <message>
        <source>no snapshot was taken before that time</source>
        <translation>在该时间之前没有保存过快照</translation>
    </message>
    <message>
        <source>The memory table at a past time is calculated from the last snapshot before that time and the writes that followed the snapshot.</source>
        <translation>过去某一时间的内存表，根据该时间之前的最后一个快照及其后的写入推算得出。</translation>
    </message>
    <message>
        <source>A stopped or interrupted test does not show how a good servo performs.</source>
        <translation>停止或中断的测试不能反映正常舵机的性能。</translation>
    </message>
    <message>
        <source>Choose a completed test.</source>
        <translation>请选择已完成的测试。</translation>
    </message>
    <message>
        <source>Later tests of this model are compared with the reference.</source>
        <translation>该型号以后的测试会与此参考对比。</translation>
    </message>
    <message>
        <source>Torque was turned off.</source>
        <translation>舵机已卸力。</translation>
    </message>
    <message>
        <source>Sending the goal turned torque on.</source>
        <translation>发送目标后，扭矩已自动打开。</translation>
    </message>
    <message>
        <source>Torque stays off until you turn it on.</source>
        <translation>在您打开扭矩之前，舵机保持卸力。</translation>
    </message>
    <message>
        <source>The servo holds its position (%3 = %1).</source>
        <translation>舵机保持在当前位置（%3 = %1）。</translation>
    </message>
    <message>
        <source>The EPROM was found unlocked.</source>
        <translation>发现 EPROM 没有上锁。</translation>
    </message>
    <message>
        <source>The EPROM has been locked.</source>
        <translation>EPROM 已上锁。</translation>
    </message>
    <message>
        <source>The EPROM lock could not be confirmed; this is recorded in the journal. Use %recover when the servo replies again.</source>
        <translation>无法确认 EPROM 已上锁；已记入写入日志。舵机恢复应答后，请使用%recover处理。</translation>
    </message>
    <message>
        <source>%3 was set to 0 to prevent unexpected movement in the new mode.</source>
        <translation>%3 已置 0，以免切换模式后舵机意外转动。</translation>
    </message>
    <message>
        <source>The angle limits (%1 to %2) are saved and will be restored when you switch back to position mode.</source>
        <translation>角度限制 %1～%2 已保存，切换回位置模式时恢复。</translation>
    </message>
    <message>
        <source>The angle limits (%1 to %2) were restored.</source>
        <translation>角度限制 %1～%2 已恢复。</translation>
    </message>
    <message>
        <source>The previous angle limits are unknown, so they were set to %1 and %2.</source>
        <translation>原来的角度限制未知，已设为 %1～%2。</translation>
    </message>
    <message>
        <source>The speed for position mode, %1 (%3), was restored.</source>
        <translation>位置模式的速度 %1（%3）已恢复。</translation>
    </message>
    <message>
        <source>%3 was set to 0; otherwise the travel time would have no effect.</source>
        <translation>%3 已置 0，否则运行时间不起作用。</translation>
    </message>
    <message>
        <source>The acknowledgment was lost; reading back confirmed the change.</source>
        <translation>没有收到应答；回读确认更改已生效。</translation>
    </message>
    <message>
        <source>The acknowledgment was lost; reading back showed no change, so the request was sent again.</source>
        <translation>没有收到应答；回读发现更改未生效，已重新发送请求。</translation>
    </message>
    <message>
        <source>The value was already set; nothing was written.</source>
        <translation>参数原来就是此值；未写入任何内容。</translation>
    </message>
    <message>
        <source>%3 is above %1, the highest useful value.</source>
        <translation>%3 超过了有意义的最大值 %1。</translation>
    </message>
    <message>
        <source>Overload: only the protection torque remains. Remove the load and set a goal away from the stalled position.</source>
        <translation>过载：只剩保护扭矩。请去除负载，并设定离开堵转位置的目标。</translation>
    </message>
    <message>
        <source>Overcurrent: torque is off until a new goal is sent. Remove the cause first.</source>
        <translation>过流：舵机已卸力，写入新目标后恢复扭矩。请先排除原因。</translation>
    </message>
    <message>
        <source>Voltage: the alarm clears when the supply voltage is back within the servo&apos;s limits.</source>
        <translation>过压欠压：供电电压回到允许范围后，报警自动解除。</translation>
    </message>
    <message>
        <source>Temperature: the alarm clears only when the servo cools down.</source>
        <translation>过温：舵机冷却后，报警才会解除。</translation>
    </message>
    <message>
        <source>Sensor: turn the servo off and on; if the alarm returns, the servo needs repair.</source>
        <translation>传感器：请断电再上电；如再次报警，舵机需要返修。</translation>
    </message>
    <message>
        <source>The servo replied %1 ms after the reboot.</source>
        <translation>舵机重启后 %1 毫秒恢复应答。</translation>
    </message>
    <message>
        <source>The servo now replies at %1 baud.</source>
        <translation>舵机现在以波特率 %1 应答。</translation>
    </message>
    <message>
        <source>The servo will keep moving to the goal unless it is stopped or torque is turned off.</source>
        <translation>舵机仍在向目标位置运动；如需停下，请发出停止指令或卸力。</translation>
    </message>
    <message>
        <source>The servo now replies as ID %1.</source>
        <translation>舵机现在以 ID %1 应答。</translation>
    </message>
    <message>
        <source>Reading back showed no change, so the request was sent again.</source>
        <translation>回读发现写入未生效，已重新发送请求。</translation>
    </message>
    <message>
        <source>%3 was saved with the command from the data sheet; this can be verified only by turning the servo off and on.</source>
        <translation>%3 已用规格书给出的指令保存；只有将舵机断电再上电，才能验证是否已保存。</translation>
    </message>
    <message>
        <source>The current limit %1 (%3) was restored.</source>
        <translation>电流限制已恢复为 %1（%3）。</translation>
    </message>
    <message>
        <source>SCS servos share this bus with STS, SMS or HLS servos; the vendor advises against this combination.</source>
        <translation>SCS 舵机与 STS、SMS 或 HLS 舵机接在同一总线上；厂家不建议混用。</translation>
    </message>
    <message>
        <source>The LED setting (%3) could not be restored; this is recorded in the journal. Use %recover when the servo replies again.</source>
        <translation>LED 设置（%3）未能恢复；已记入写入日志。舵机恢复应答后，请使用%recover处理。</translation>
    </message>
    <message>
        <source>Not recorded: the result of this change could not be saved to the history (%3). The change stays listed as unfinished; use %recover when the history is writable again.</source>
        <translation>未记录：这次更改的结果无法存入历史记录（%3）。该更改仍列为未写完；历史记录可以写入后，请使用%recover处理。</translation>
    </message>
    <message>
        <source>%3 could not be restored to %1; this is recorded in the journal. Use %recover when the servo replies again. At power-off, the servo discards the temporary value.</source>
        <translation>%3 未能恢复为 %1；已记入写入日志。舵机恢复应答后，请使用%recover处理。断电后舵机会自行丢弃临时值。</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>已上锁</translation>
    </message>
    <message>
        <source>unlocked</source>
        <translation>未上锁</translation>
    </message>
    <message>
        <source>not confirmed</source>
        <translation>未确认上锁</translation>
    </message>
    <message>
        <source>not affected</source>
        <translation>不涉及</translation>
    </message>
    <message>
        <source>The servo may keep moving to the goal with torque on unless it is stopped or torque is turned off.</source>
        <translation>舵机可能仍在向目标位置运动，扭矩也可能仍打开；如需停下，请发出停止指令或卸力。</translation>
    </message>
    <message>
        <source>TTL, half duplex</source>
        <translation>TTL 半双工单线</translation>
    </message>
    <message>
        <source>This family has a fixed baud rate and no command to change it.</source>
        <translation>该系列只有一种波特率，没有修改波特率的指令。</translation>
    </message>
    <message>
        <source>Set the other servos and the port to this baud rate.</source>
        <translation>请把其他舵机和端口设为此波特率。</translation>
    </message>
    <message>
        <source>no reply</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>This register affects the servo&apos;s communication, protection or direction of rotation.</source>
        <translation>此参数影响舵机的通信、保护或旋转方向。</translation>
    </message>
    <message>
        <source>Position goals have no meaning in the present mode.</source>
        <translation>目标位置在当前模式下没有意义。</translation>
    </message>
    <message>
        <source>Select &quot;Switch to position mode&quot; for this test (--switch-mode on the command line), or switch the servo to position mode yourself first.</source>
        <translation>请为本次测试勾选“切换到位置模式”（命令行用 --switch-mode），或先自行将舵机切换到位置模式。</translation>
    </message>
    <message>
        <source>the servo has no reboot command</source>
        <translation>舵机没有重启指令</translation>
    </message>
    <message>
        <source>Turn the power supply off and on.</source>
        <translation>请断电后重新上电。</translation>
    </message>
    <message>
        <source>the servo cannot reset itself to factory defaults</source>
        <translation>舵机不能自行恢复出厂设置</translation>
    </message>
    <message>
        <source>the servo cannot share a packet with other servos</source>
        <translation>舵机不能与其他舵机共用一个数据包</translation>
    </message>
    <message>
        <source>Send the goals one by one.</source>
        <translation>请逐个发送目标。</translation>
    </message>
    <message>
        <source>the servo cannot store a goal for later</source>
        <translation>舵机不能暂存目标等待执行</translation>
    </message>
    <message>
        <source>This family does not support asynchronous writes.</source>
        <translation>该系列不支持异步写。</translation>
    </message>
    <message>
        <source>the servo&apos;s mode differs from that of the first servo</source>
        <translation>舵机的模式与第一个舵机不同</translation>
    </message>
    <message>
        <source>The same goal would have a different meaning for this servo.</source>
        <translation>同一个目标对此舵机有不同的含义。</translation>
    </message>
    <message>
        <source>Switch all servos to the same mode first.</source>
        <translation>请先把所有舵机切换到同一模式。</translation>
    </message>
    <message>
        <source>a mode and its goal cannot be written together</source>
        <translation>模式与该模式的目标值不能同时写入</translation>
    </message>
    <message>
        <source>A mode change first sets the goal to zero to prevent unexpected movement.</source>
        <translation>切换模式时先把目标值清零，以免舵机意外转动。</translation>
    </message>
    <message>
        <source>Change the mode first, then send the goal.</source>
        <translation>请先切换模式，再发送目标值。</translation>
    </message>
    <message>
        <source>The travel time determines the speed.</source>
        <translation>速度由运行时间决定。</translation>
    </message>
    <message>
        <source>Use a travel time instead.</source>
        <translation>请改用运行时间。</translation>
    </message>
    <message>
        <source>no reply to this read request</source>
        <translation>舵机没有应答此读取请求</translation>
    </message>
    <message>
        <source>Some models in this family do not have this command; the connection is good.</source>
        <translation>该系列部分型号没有此指令；线路正常。</translation>
    </message>
    <message>
        <source>You can ignore this value.</source>
        <translation>此数值可以忽略。</translation>
    </message>
    <message>
        <source>the time must be written together with a goal</source>
        <translation>时间须与目标一起写入</translation>
    </message>
    <message>
        <source>One command contains both goal and time, so writing only the time would send the last goal again.</source>
        <translation>目标和时间在同一条指令中，单独写入时间会重新发送上一次的目标。</translation>
    </message>
    <message>
        <source>Write the goal and the time together.</source>
        <translation>请同时写入目标和时间。</translation>
    </message>
    <message>
        <source>this setting is always kept after power-off</source>
        <translation>此参数断电后总会保留</translation>
    </message>
    <message>
        <source>The servo stores the value immediately and has no lock to prevent this.</source>
        <translation>舵机会立即保存该值，没有锁标志可以阻止保存。</translation>
    </message>
    <message>
        <source>Write the value permanently, then write the old value back.</source>
        <translation>请永久写入该值，之后再写回原值。</translation>
    </message>
    <message>
        <source>the servo has no controllable LED</source>
        <translation>舵机没有可控制的 LED</translation>
    </message>
    <message>
        <source>This family&apos;s memory table has no LED register.</source>
        <translation>该系列的内存表没有 LED 参数。</translation>
    </message>
    <message>
        <source>With torque off, turn a shaft by hand and check which servo&apos;s position changes.</source>
        <translation>请先卸力，用手转动输出轴，看哪个舵机的位置在变化。</translation>
    </message>
    <message>
        <source>the servo&apos;s LED setting is one of the factory values</source>
        <translation>舵机的 LED 设置属于出厂参数</translation>
    </message>
    <message>
        <source>Blinking the LED would require unlocking and rewriting these values many times.</source>
        <translation>要让 LED 闪烁，就得解锁并多次改写出厂参数。</translation>
    </message>
    <message>
        <source>in this mode, the servo cannot back off from the stalled position by a small amount</source>
        <translation>此模式下舵机无法只往回转一点来解除堵转</translation>
    </message>
    <message>
        <source>Only turning in the opposite direction clears an overload alarm; in this mode, the shaft would keep turning.</source>
        <translation>过载报警只能靠反方向转动解除，而在此模式下输出轴会一直转下去。</translation>
    </message>
    <message>
        <source>Remove the load and send a command in the opposite direction, or turn the power supply off and on.</source>
        <translation>请去除负载，自行发送反方向指令，或断电后重新上电。</translation>
    </message>
    <message>
        <source>the direction of the stall is unknown</source>
        <translation>无法判断堵转方向</translation>
    </message>
    <message>
        <source>The servo is at its goal and is not pushing in either direction.</source>
        <translation>舵机停在目标处，没有向任何一侧出力。</translation>
    </message>
    <message>
        <source>Remove the load and set a goal away from the stalled position, or turn the power supply off and on.</source>
        <translation>请去除负载，自行设定离开堵转位置的目标，或断电后重新上电。</translation>
    </message>
    <message>
        <source>the servos use different baud rates</source>
        <translation>这些舵机的波特率不一致</translation>
    </message>
    <message>
        <source>One bus cannot run at two baud rates at the same time.</source>
        <translation>同一条总线上不能同时使用两种波特率通信。</translation>
    </message>
    <message>
        <source>Select servos with the same baud rate, or set them all to one baud rate.</source>
        <translation>请选择波特率相同的舵机，或把所有舵机改为同一波特率。</translation>
    </message>
    <message>
        <source>the servo&apos;s angle limits do not allow moving away from the stalled position</source>
        <translation>舵机的角度限制不允许离开堵转位置</translation>
    </message>
    <message>
        <source>Any goal away from the stalled position would be outside the limits.</source>
        <translation>任何离开堵转位置的目标都会超出限制。</translation>
    </message>
    <message>
        <source>Widen the limits, or turn the power supply off and on.</source>
        <translation>请放宽限制，或断电后重新上电。</translation>
    </message>
    <message>
        <source>start and end are the same position</source>
        <translation>起始位置与结束位置相同</translation>
    </message>
    <message>
        <source>There would be no travel to measure.</source>
        <translation>没有可测量的行程。</translation>
    </message>
    <message>
        <source>Enter two different positions.</source>
        <translation>请输入两个不同的位置。</translation>
    </message>
    <message>
        <source>The end would never be reached.</source>
        <translation>这样永远到不了结束位置。</translation>
    </message>
    <message>
        <source>Enter a step of 1 or more.</source>
        <translation>请输入不小于 1 的步长。</translation>
    </message>
    <message>
        <source>The path runs in both directions, so the step has no sign.</source>
        <translation>往返都按此步长运动，步长不分正负。</translation>
    </message>
    <message>
        <source>Enter a step of 1 or more; to reverse the direction, swap start and end.</source>
        <translation>请输入不小于 1 的步长；若要反方向，请对调起始位置和结束位置。</translation>
    </message>
    <message>
        <source>the step is larger than the distance from start to end</source>
        <translation>步长大于起始位置到结束位置的距离</translation>
    </message>
    <message>
        <source>Start and end are closer together than one step.</source>
        <translation>起始位置与结束位置的距离比步长还小。</translation>
    </message>
    <message>
        <source>Use a smaller step, or move start and end farther apart.</source>
        <translation>请减小步长，或加大起始位置与结束位置的距离。</translation>
    </message>
    <message>
        <source>the list has fewer than two goals</source>
        <translation>列表中的目标少于两个</translation>
    </message>
    <message>
        <source>A test moves the servo between at least two positions.</source>
        <translation>测试需要舵机在至少两个位置之间运动。</translation>
    </message>
    <message>
        <source>Put at least two goals in the file, one per line.</source>
        <translation>请在文件中写入至少两个目标，每行一个。</translation>
    </message>
    <message>
        <source>The servo would be sent back before it has moved.</source>
        <translation>舵机还没动，就会收到返回的指令。</translation>
    </message>
    <message>
        <source>Enter a delay longer than one move takes, or use a dwell after arrival.</source>
        <translation>延时应大于运动所需时间，或改为到位后停留。</translation>
    </message>
    <message>
        <source>Neither a number of cycles nor a duration is set.</source>
        <translation>既没有设置循环次数，也没有设置时长。</translation>
    </message>
    <message>
        <source>Set a number of cycles or a duration.</source>
        <translation>请设置循环次数或时长。</translation>
    </message>
    <message>
        <source>the period of the sine wave is not set</source>
        <translation>没有设置正弦波的周期</translation>
    </message>
    <message>
        <source>The speed of the movement is undefined.</source>
        <translation>无法确定运动速度。</translation>
    </message>
    <message>
        <source>Enter the period in seconds.</source>
        <translation>请输入周期（秒）。</translation>
    </message>
    <message>
        <source>With a step of 0, there is no response to measure.</source>
        <translation>阶跃为 0 时没有可测量的响应。</translation>
    </message>
    <message>
        <source>Enter a nonzero step; it may be negative.</source>
        <translation>请输入不为 0 的阶跃大小，可为负数。</translation>
    </message>
    <message>
        <source>the time between goals is out of range</source>
        <translation>目标间隔时间超出范围</translation>
    </message>
    <message>
        <source>All readings of a response are stored, so the time is limited to ten seconds.</source>
        <translation>每次响应的所有采样都会保存，因此时间最长为十秒。</translation>
    </message>
    <message>
        <source>Enter ten seconds or less, or leave the field empty to use the calculated time.</source>
        <translation>请输入不超过十秒的时间，或留空，由程序计算。</translation>
    </message>
    <message>
        <source>the number of repeats is out of range</source>
        <translation>往返次数超出范围</translation>
    </message>
    <message>
        <source>All readings are stored, so a run is limited to fifty steps in each direction.</source>
        <translation>所有采样都会保存，因此一次测试最多往返五十次。</translation>
    </message>
    <message>
        <source>Enter a number from 1 to 50.</source>
        <translation>请输入 1 到 50 之间的数。</translation>
    </message>
    <message>
        <source>this register cannot be used in a trial</source>
        <translation>该参数不能试用</translation>
    </message>
    <message>
        <source>A trial can change only the gains, the startup force, the integral limit and the dead zones, if the servo has them.</source>
        <translation>试用只能设置增益、启动力、积分限制和死区（视舵机而定）。</translation>
    </message>
    <message>
        <source>no data is being read</source>
        <translation>当前没有读取任何数据</translation>
    </message>
    <message>
        <source>There is nothing to record.</source>
        <translation>没有可记录的内容。</translation>
    </message>
    <message>
        <source>Connect, select a servo and choose channels first.</source>
        <translation>请先连接总线，再选择舵机和通道。</translation>
    </message>
    <message>
        <source>a test has exclusive use of the bus</source>
        <translation>测试正在独占总线</translation>
    </message>
    <message>
        <source>Other communication on the bus would distort the measurement.</source>
        <translation>总线上的其他通信会影响测量结果。</translation>
    </message>
    <message>
        <source>Wait until the test ends, or stop it.</source>
        <translation>请等测试结束，或停止测试。</translation>
    </message>
    <message>
        <source>another program is still working on this change</source>
        <translation>另一个程序仍在进行此更改</translation>
    </message>
    <message>
        <source>The program that started the change is still running.</source>
        <translation>开始此更改的程序仍在运行。</translation>
    </message>
    <message>
        <source>Wait until the other program has finished. If it exits early, you can finish or undo the change here.</source>
        <translation>请等待该程序完成。如果该程序提前退出，可在此处完成或撤销此更改。</translation>
    </message>
    <message>
        <source>movement is blocked after the emergency stop</source>
        <translation>急停后禁止运动</translation>
    </message>
    <message>
        <source>Torque was turned off on the whole bus and has not been turned on again.</source>
        <translation>总线上的所有舵机已卸力，此后尚未重新打开扭矩。</translation>
    </message>
    <message>
        <source>Make sure that nothing can move unexpectedly, turn torque on, then start again.</source>
        <translation>请确认没有部件会意外转动，打开扭矩后再重新开始。</translation>
    </message>
    <message>
        <source>writing this value moves the shaft immediately</source>
        <translation>写入后输出轴会立即转动</translation>
    </message>
    <message>
        <source>The servo follows the new value immediately.</source>
        <translation>舵机收到新值后立即执行。</translation>
    </message>
    <message>
        <source>clearing this alarm moves the shaft</source>
        <translation>解除此报警会使输出轴转动</translation>
    </message>
    <message>
        <source>Only a goal away from the stalled position clears an overload alarm.</source>
        <translation>须写入能使舵机离开堵转位置的目标，才能解除过载报警。</translation>
    </message>
    <message>
        <source>Keep clear of the mechanism, then repeat this action and confirm it explicitly.</source>
        <translation>请远离机构，然后重新执行此操作，并按提示确认。</translation>
    </message>
    <message>
        <source>clearing this alarm turns torque on</source>
        <translation>解除此报警会打开扭矩</translation>
    </message>
    <message>
        <source>Only a new goal clears an overcurrent alarm.</source>
        <translation>须重新写入目标，才能解除过流报警。</translation>
    </message>
    <message>
        <source>Remove the cause and keep clear of the mechanism, then repeat this action and confirm it explicitly.</source>
        <translation>请先排除故障原因并远离机构，然后重新执行此操作，并按提示确认。</translation>
    </message>
    <message>
        <source>The servo&apos;s state has changed in the meantime.</source>
        <translation>其间舵机状态已改变。</translation>
    </message>
    <message>
        <source>Check the alarm again, then decide whether to clear it.</source>
        <translation>请重新查看报警，再决定是否解除。</translation>
    </message>
    <message>
        <source>the servo did not reboot</source>
        <translation>舵机没有重启</translation>
    </message>
    <message>
        <source>The servo replies, and its RAM is unchanged: the servo ignored or did not receive the reboot command.</source>
        <translation>舵机有应答，RAM 内容未变：舵机忽略了重启指令，或没有收到该指令。</translation>
    </message>
    <message>
        <source>the servo acknowledged the reboot command but did not reboot</source>
        <translation>舵机应答了重启指令，但没有重启</translation>
    </message>
    <message>
        <source>The servo replies, and its RAM is unchanged.</source>
        <translation>舵机有应答，RAM 内容未变。</translation>
    </message>
    <message>
        <source>the reboot could not be confirmed</source>
        <translation>无法确认舵机是否已重启</translation>
    </message>
    <message>
        <source>The servo replies but shows no sign of a reboot: it ignored the command, or rebooted too quickly to be noticed.</source>
        <translation>舵机有应答，但没有重启过的迹象：可能忽略了该指令，也可能重启太快而未被察觉。</translation>
    </message>
    <message>
        <source>To be sure, turn the power supply off and on.</source>
        <translation>请断电再上电，以确保重启。</translation>
    </message>
    <message>
        <source>the servo did not reach the start position of the test</source>
        <translation>舵机没有到达测试的起始位置</translation>
    </message>
    <message>
        <source>The servo is blocked, too weak or too slow, or its limits prevent the movement.</source>
        <translation>舵机可能被卡住、力量不足、速度太慢，或者参数限制使其无法到达。</translation>
    </message>
    <message>
        <source>Remove the obstacle, then check the torque limit, speed and alarms.</source>
        <translation>请清除障碍物，再检查扭矩限制、速度和报警。</translation>
    </message>
    <message>
        <source>the servo rebooted before its first step</source>
        <translation>舵机在第一次阶跃之前已重启</translation>
    </message>
    <message>
        <source>The power supply was interrupted and the trial values were lost, so the servo moved with its old values.</source>
        <translation>供电曾短暂中断，试用值随之丢失，因此舵机是以原值运动的。</translation>
    </message>
    <message>
        <source>Check the plug and the power supply, then measure the step response again.</source>
        <translation>请检查插头和供电，然后重新测量阶跃响应。</translation>
    </message>
    <message>
        <source>the servo&apos;s operating mode has changed</source>
        <translation>舵机的运行模式已改变</translation>
    </message>
    <message>
        <source>Another program has changed the mode. In the new mode, this goal has a different meaning.</source>
        <translation>模式已被其他程序切换，这个目标在新模式下含义不同。</translation>
    </message>
    <message>
        <source>Check which mode is now shown, then send a goal for that mode.</source>
        <translation>请先查看当前显示的模式，再发送适用于该模式的目标。</translation>
    </message>
    <message>
        <source>a goal waiting in the servo could not be removed</source>
        <translation>舵机中待执行的目标无法清除</translation>
    </message>
    <message>
        <source>The next Execute command, from any program, will move the servo to this goal.</source>
        <translation>下一条“异步执行”指令（无论来自哪个程序）会让舵机转到这个目标。</translation>
    </message>
    <message>
        <source>Turn the servo off and on to discard this goal.</source>
        <translation>请将舵机断电再上电，以丢弃该目标。</translation>
    </message>
    <message>
        <source>this step would go beyond ±7.5 turns</source>
        <translation>这一步将超出 ±7.5 圈</translation>
    </message>
    <message>
        <source>The servo cannot count beyond ±7.5 turns. The displayed total includes all steps since you connected.</source>
        <translation>舵机的计数不能超过 ±7.5 圈。显示的总数是连接以来步进量的总和。</translation>
    </message>
    <message>
        <source>Step in the opposite direction.</source>
        <translation>请向相反方向步进。</translation>
    </message>
    <message>
        <source>the servo rebooted or was replaced during the write, so it is unknown whether the value was saved</source>
        <translation>舵机在写入过程中重启或被更换，因此不知道该值是否已保存</translation>
    </message>
    <message>
        <source>The power supply was interrupted, or another servo with this ID was connected.</source>
        <translation>供电瞬间中断，或换上了 ID 相同的另一个舵机。</translation>
    </message>
    <message>
        <source>Check the plug and the power supply, connect the original servo, then check the unfinished change (%recover).</source>
        <translation>请检查插头和供电，接上原来的舵机，然后查看未写完的更改（%recover）。</translation>
    </message>
    <message>
        <source>the servo did not acknowledge the command, and all values are unchanged, so it is unknown whether the command was executed</source>
        <translation>舵机没有应答该指令，所有值都与之前相同，因此不知道指令是否已执行</translation>
    </message>
    <message>
        <source>The firmware ignores this command, or all settings already had their default values.</source>
        <translation>固件忽略该指令，或所有设置原本就是出厂默认值。</translation>
    </message>
    <message>
        <source>Compare the servo&apos;s memory table with the defaults, and write the values that differ.</source>
        <translation>请将内存表与出厂默认值对比，并把有差异的参数改为出厂默认值。</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>相同</translation>
    </message>
    <message>
        <source>The servo already has this value; nothing is written.</source>
        <translation>舵机中已是此值，无需写入。</translation>
    </message>
    <message>
        <source>identity: not written by default</source>
        <translation>身份参数：默认不写</translation>
    </message>
    <message>
        <source>The ID and baud rate identify the servo. They are written only on request, as the last step.</source>
        <translation>ID 和波特率用于识别舵机，仅在您要求时写入，且放在最后。</translation>
    </message>
    <message>
        <source>live value: never restored</source>
        <translation>实时值：从不恢复</translation>
    </message>
    <message>
        <source>Torque, goals and the lock are saved for reference only, because writing them back could turn the shaft.</source>
        <translation>扭矩、目标和上锁状态仅存作参考，因为写回可能使输出轴转动。</translation>
    </message>
    <message>
        <source>lost at power-off: not written by default</source>
        <translation>断电丢失：默认不写</translation>
    </message>
    <message>
        <source>The servo resets this value at each power-on.</source>
        <translation>舵机每次上电都会重新设定此值。</translation>
    </message>
    <message>
        <source>shifts the zero position of the shaft</source>
        <translation>会移动输出轴的零位</translation>
    </message>
    <message>
        <source>After the write, the same goal means a different position: the shaft may turn immediately or when torque is turned on.</source>
        <translation>写入后同一目标对应另一位置：输出轴可能立即转动，或在打开扭矩时转动。</translation>
    </message>
    <message>
        <source>This value was set at the factory for this individual servo.</source>
        <translation>此值由厂家为该舵机单独设定。</translation>
    </message>
    <message>
        <source>The file is from a different model or firmware version; this row cannot be written.</source>
        <translation>文件来自其他型号或固件版本；此行无法写入。</translation>
    </message>
    <message>
        <source>The file is from a different model or firmware version; this row stays unchanged.</source>
        <translation>文件来自其他型号或固件版本；此行保持不变。</translation>
    </message>
    <message>
        <source>The value could not be read when the file was saved.</source>
        <translation>保存文件时未能读出该值。</translation>
    </message>
    <message>
        <source>A value that cannot be read back cannot be verified, so it is not written.</source>
        <translation>无法回读的值不能验证，因此不写入。</translation>
    </message>
    <message>
        <source>This servo does not accept the value in the file.</source>
        <translation>此舵机不接受文件中的值。</translation>
    </message>
    <message>
        <source>different meaning on this servo</source>
        <translation>在此舵机上含义不同</translation>
    </message>
    <message>
        <source>The unit or number format in the file differs from that of this servo.</source>
        <translation>文件中的单位或数值格式与该舵机的不同。</translation>
    </message>
    <message>
        <source>unitless number from another family</source>
        <translation>另一系列的无单位数值</translation>
    </message>
    <message>
        <source>Without a unit, the number may have a different meaning on this servo. It is not written by default.</source>
        <translation>该数值没有单位，在此舵机上的含义可能不同。默认不写。</translation>
    </message>
    <message>
        <source>not selected</source>
        <translation>未选择</translation>
    </message>
    <message>
        <source>The request did not include this row.</source>
        <translation>没有要求写入此行。</translation>
    </message>
    <message>
        <source>Voltage, temperature, current and torque limits depend on the model. Each is written only if you select its row.</source>
        <translation>电压、温度、电流和扭矩的限值与型号有关。只有您勾选的行才会写入。</translation>
    </message>
    <message>
        <source>not permanent yet</source>
        <translation>尚未永久保存</translation>
    </message>
    <message>
        <source>This value was written only temporarily and would be lost at power-off. It will be written again, this time permanently.</source>
        <translation>舵机现在已是此值，但属于临时写入，断电即失效。将再次写入，以永久保存。</translation>
    </message>
    <message>
        <source>The present reading is outside this limit: the servo would report an alarm as soon as the limit is written.</source>
        <translation>当前测量值超出此限值：一旦写入该限值，舵机就会报警。</translation>
    </message>
    <message>
        <source>turn torque off and leave it off</source>
        <translation>卸力，并保持卸力</translation>
    </message>
    <message>
        <source>unlock the EPROM</source>
        <translation>解锁 EPROM</translation>
    </message>
    <message>
        <source>stop in the new mode</source>
        <translation>在新模式下停止转动</translation>
    </message>
    <message>
        <source>lock the EPROM and verify the lock</source>
        <translation>将 EPROM 上锁并确认</translation>
    </message>
    <message>
        <source>failed; everything is unchanged</source>
        <translation>失败；一切保持原样</translation>
    </message>
    <message>
        <source>different servo; not changed</source>
        <translation>是另一个舵机；未作更改</translation>
    </message>
    <message>
        <source>would cause a voltage alarm now: limit %1, present voltage %2</source>
        <translation>写入后会立即引起过压欠压报警：限值 %1，当前电压 %2</translation>
    </message>
    <message>
        <source>would cause a temperature alarm now: limit %1, present temperature %2</source>
        <translation>写入后会立即引起过温报警：上限 %1，当前温度 %2</translation>
    </message>
    <message>
        <source>would cause an overcurrent alarm now: limit %1, present current %2</source>
        <translation>写入后会立即引起过流报警：上限 %1，当前电流 %2</translation>
    </message>
    <message>
        <source>would cause an overload alarm now: limit %1, present load %2</source>
        <translation>写入后会立即引起过载报警：上限 %1，当前负载 %2</translation>
    </message>
    <message>
        <source>The server is turned off or restarting, the network is down, or the host name or port is wrong.</source>
        <translation>服务器已关机或正在重启、网络中断，或主机名或端口写错。</translation>
    </message>
    <message>
        <source>No data is lost: pending data is sent when the server is back. Check the host and port in the connection string.</source>
        <translation>没有丢失任何数据：服务器恢复后会补发。请检查连接字符串中的主机和端口。</translation>
    </message>
    <message>
        <source>the history server does not respond</source>
        <translation>历史记录服务器没有响应</translation>
    </message>
    <message>
        <source>The server accepts connections but does not reply: it has hung, a firewall is blocking it, or it is not a PostgreSQL server.</source>
        <translation>服务器接受连接但没有响应：服务器卡死、被防火墙拦截，或者不是 PostgreSQL 服务器。</translation>
    </message>
    <message>
        <source>No data is lost: pending data is sent when the server responds again. Check the server, host and port.</source>
        <translation>没有丢失任何数据：服务器恢复响应后会补发。请检查服务器、主机和端口。</translation>
    </message>
    <message>
        <source>the history server rejects this password</source>
        <translation>历史记录服务器不接受该密码</translation>
    </message>
    <message>
        <source>The database name is misspelled, or the database has not been created yet.</source>
        <translation>数据库名称写错，或数据库尚未创建。</translation>
    </message>
    <message>
        <source>Create the database on the server: &quot;createdb -E UTF8 -O USER DATABASE&quot;.</source>
        <translation>请在服务器上创建数据库：“createdb -E UTF8 -O USER DATABASE”。</translation>
    </message>
    <message>
        <source>the history server does not allow this</source>
        <translation>历史记录服务器不允许此操作</translation>
    </message>
    <message>
        <source>This user cannot log in from here, has only read permission, or cannot create tables in this database.</source>
        <translation>该用户不能从此处登录、只有读取权限，或不能在该数据库中建表。</translation>
    </message>
    <message>
        <source>Ask the owner of the database for permission (GRANT, pg_hba.conf), or use another user.</source>
        <translation>请数据库所有者授权（GRANT、pg_hba.conf），或换用其他用户。</translation>
    </message>
    <message>
        <source>The certificate has expired, this computer does not trust its issuer, or another computer is posing as the server.</source>
        <translation>证书已过期，本机不信任其签发机构，或者有另一台计算机在冒充该服务器。</translation>
    </message>
    <message>
        <source>The server name in the connection string does not match the certificate, or another computer is posing as the server.</source>
        <translation>连接字符串中的服务器名称与证书不符，或者有另一台计算机在冒充该服务器。</translation>
    </message>
    <message>
        <source>Use the host name in the certificate, or get a certificate for this host name. sslmode=verify-ca checks only the issuer.</source>
        <translation>请使用证书中的主机名，或为此主机名签发证书。sslmode=verify-ca 只检查签发机构。</translation>
    </message>
    <message>
        <source>Other users could read the password in the settings and in the process list, so it is neither used nor saved.</source>
        <translation>其他人可能从设置文件和进程列表中读到密码，因此既不使用也不保存该密码。</translation>
    </message>
    <message>
        <source>The parameter is misspelled, or it might contain a password.</source>
        <translation>参数名拼写有误，或该参数可能含有密码。</translation>
    </message>
    <message>
        <source>the history server rejects the login</source>
        <translation>历史记录服务器拒绝登录</translation>
    </message>
    <message>
        <source>The server&apos;s message gives the reason, in the language set on the server.</source>
        <translation>具体原因见服务器返回的消息（语言取决于服务器设置）。</translation>
    </message>
    <message>
        <source>Check the user, password and database in the connection string, and check the server&apos;s log.</source>
        <translation>请检查连接字符串中的用户、密码和数据库，以及服务器日志。</translation>
    </message>
    <message>
        <source>this computer cannot connect to PostgreSQL servers</source>
        <translation>本机无法与 PostgreSQL 服务器通信</translation>
    </message>
    <message>
        <source>Qt&apos;s PostgreSQL driver is not installed.</source>
        <translation>未安装 Qt 的 PostgreSQL 驱动。</translation>
    </message>
    <message>
        <source>Install the driver (Debian: &quot;sudo apt install libqt6sql6-psql&quot;), then restart the program.</source>
        <translation>请安装驱动（Debian：“sudo apt install libqt6sql6-psql”），然后重新启动程序。</translation>
    </message>
    <message>
        <source>Another bench uses a newer version of this program, which has updated the tables on the server.</source>
        <translation>另一工位使用了本程序的较新版本，并已升级服务器上的表。</translation>
    </message>
    <message>
        <source>Update this program as well. Until then, all data is kept on this computer.</source>
        <translation>请同时升级本程序。在此之前，所有数据都保存在本机。</translation>
    </message>
    <message>
        <source>The tables are updated when a bench with this version of the program sends data for the first time.</source>
        <translation>第一个用此版本发送数据的工位会升级服务器上的表。</translation>
    </message>
    <message>
        <source>Send data from a bench that uses this version.</source>
        <translation>请从使用此版本的工位发送数据。</translation>
    </message>
    <message>
        <source>no data has been sent to this history server yet</source>
        <translation>尚未向该历史记录服务器发送过任何数据</translation>
    </message>
    <message>
        <source>No bench uses this database yet, or the connection string names the wrong one.</source>
        <translation>还没有工位使用该数据库，或连接字符串指向了其他数据库。</translation>
    </message>
    <message>
        <source>Set the connection string on each bench computer, then try again.</source>
        <translation>请在各工位设置连接字符串，然后再试。</translation>
    </message>
    <message>
        <source>this database cannot store text in all languages</source>
        <translation>该数据库不能保存所有语言的文字</translation>
    </message>
    <message>
        <source>Create another database: &quot;createdb -E UTF8 -T template0 DATABASE&quot;.</source>
        <translation>请另建一个数据库：“createdb -E UTF8 -T template0 DATABASE”。</translation>
    </message>
    <message>
        <source>The server has reached its maximum number of connections, or the tables are locked.</source>
        <translation>连接数已达上限，或数据表被锁住。</translation>
    </message>
    <message>
        <source>No data is lost; the program tries again automatically. If the problem continues, check the server.</source>
        <translation>没有丢失任何数据，程序会自动重试。若一直如此，请检查服务器。</translation>
    </message>
    <message>
        <source>There is no space left for the database tables.</source>
        <translation>空间不足，无法存放数据库的表。</translation>
    </message>
    <message>
        <source>Free up some space on the server. Until then, data is kept on this computer; it will be sent later.</source>
        <translation>请在服务器上腾出空间。在此之前数据保存在本机，之后补发。</translation>
    </message>
    <message>
        <source>this is not a valid PostgreSQL connection string</source>
        <translation>这不是有效的 PostgreSQL 连接字符串</translation>
    </message>
    <message>
        <source>The string has neither the form postgresql://USER@HOST/DATABASE nor the form host=HOST dbname=DATABASE user=USER, or part of it is not recognized.</source>
        <translation>连接字符串格式有误，或含有无法识别的部分。正确格式：postgresql://USER@HOST/DATABASE，或 host=HOST dbname=DATABASE user=USER。</translation>
    </message>
    <message>
        <source>Correct the string; the PostgreSQL manual describes its format under &quot;Connection Strings&quot;.</source>
        <translation>请更正该字符串；PostgreSQL 手册的“Connection Strings”一节说明了其格式。</translation>
    </message>
    <message>
        <source>The server is not in the state this program expects.</source>
        <translation>服务器的状态与本程序的预期不符。</translation>
    </message>
    <message>
        <source>No data is lost; the program tries again automatically. If the problem continues, check the server&apos;s log.</source>
        <translation>没有丢失任何数据，程序会自动重试。若一直如此，请查看服务器日志。</translation>
    </message>
    <message>
        <source>another servo already has this label</source>
        <translation>另一个舵机已有此标签</translation>
    </message>
    <message>
        <source>Both servos have the same model, firmware and ID, so only the label distinguishes them.</source>
        <translation>两个舵机的型号、固件和 ID 都相同，只能靠标签区分。</translation>
    </message>
    <message>
        <source>Choose another label, or confirm that the servo now replying is the one with this label.</source>
        <translation>请换一个标签；如果当前应答的舵机就是原来使用此标签的舵机，请予以确认。</translation>
    </message>
    <message>
        <source>The servos that were found reply reliably.</source>
        <translation>找到的舵机应答均正常。</translation>
    </message>
    <message>
        <source>No servo is connected, or the servos have no power.</source>
        <translation>没有连接舵机，或舵机没有供电。</translation>
    </message>
    <message>
        <source>Measure the supply voltage at a servo&apos;s connector. On an adapter board, connect the supply to the terminal next to the servo connectors; USB does not power servos. Then try one servo alone, with another cable, and check that RS-485 servos are connected to the RS-485 connector and all others to the TTL connector.</source>
        <translation>请在舵机插头处测量供电电压。使用适配器板时，电源应接在舵机接口旁的端子上；USB 不给舵机供电。然后换一根线，只接一个舵机再试，并确认 RS-485 舵机接在 RS-485 接口上，其他舵机接在 TTL 接口上。</translation>
    </message>
    <message>
        <source>Only the adapter&apos;s echo comes back; no servo replies.</source>
        <translation>只收到适配器的回显，没有舵机应答。</translation>
    </message>
    <message>
        <source>The adapter works. Measure the supply voltage at a servo&apos;s connector, check that the data wire and the ground reach the servo, and try one servo alone.</source>
        <translation>适配器工作正常。请在舵机插头处测量供电电压，检查数据线和地线是否接到舵机，并只接一个舵机再试。</translation>
    </message>
    <message>
        <source>Some servos use a different baud rate.</source>
        <translation>有舵机使用了不同的波特率。</translation>
    </message>
    <message>
        <source>Connect at the baud rate at which they were found. To use one rate for all servos, change it in each of them.</source>
        <translation>请用找到这些舵机时的波特率连接。如需统一波特率，请逐个修改舵机的设置。</translation>
    </message>
    <message>
        <source>Some servos use a protocol other than the one selected.</source>
        <translation>有舵机使用的协议与所选协议不同。</translation>
    </message>
    <message>
        <source>Select the protocol with which they were found, or use automatic selection.</source>
        <translation>请选择找到这些舵机时的协议，或选择自动识别。</translation>
    </message>
    <message>
        <source>Several servos have the same ID.</source>
        <translation>多个舵机的 ID 相同。</translation>
    </message>
    <message>
        <source>Disconnect all but one of these servos, give the remaining servo an unused ID, then connect the next one. Commissioning guides you through the steps.</source>
        <translation>请只保留其中一个，为它设置一个未使用的 ID，再接下一个。“批量设置”页会引导您完成。</translation>
    </message>
    <message>
        <source>The adapter delays the replies.</source>
        <translation>适配器转发应答较慢。</translation>
    </message>
    <message>
        <source>ServoDesk waits for late replies, but other programs may not find any servos; set their timeouts to more than this delay. For an FTDI adapter, set the latency timer to 1 ms (on Linux in /sys/bus/usb-serial/devices/ttyUSB0/latency_timer, on Windows in Device Manager). If you use a network bridge, connect to it by cable.</source>
        <translation>ServoDesk 会等待较晚的应答，但其他程序可能找不到舵机：请将这些程序的超时设为大于此延迟。FTDI 适配器请把延迟计时器设为 1 毫秒（Linux 下为 /sys/bus/usb-serial/devices/ttyUSB0/latency_timer，Windows 下在设备管理器中设置）。网桥请使用有线连接。</translation>
    </message>
    <message>
        <source>Some servos do not acknowledge writes (response level 0).</source>
        <translation>有舵机不应答写指令（应答级别为 0）。</translation>
    </message>
    <message>
        <source>ServoDesk reads back every value it writes. Other programs may report that the servo does not reply; to prevent this, set the response level to 1.</source>
        <translation>ServoDesk 每次写入后都会回读。其他程序可能报告舵机不应答：请把应答级别设为 1。</translation>
    </message>
    <message>
        <source>Replies are damaged or lost on the line.</source>
        <translation>应答在线路上损坏或丢失。</translation>
    </message>
    <message>
        <source>Check the connectors and cables, connect the grounds of the adapter and the power supply, and keep cables short. Then disconnect the servos one after another: a single faulty servo can disturb the whole bus. If this happens only while servos move, the power supply is too weak.</source>
        <translation>请检查插头和导线，将适配器与电源共地，并使用较短的导线。然后逐个拔下舵机：一个有故障的舵机就可能干扰整条总线。如果只在舵机转动时出现，说明电源功率不足。</translation>
    </message>
    <message>
        <source>The device on this port sends text from its own program instead of servo data.</source>
        <translation>该端口上的设备发送的是自身程序输出的文本，而不是舵机数据。</translation>
    </message>
    <message>
        <source>The port belongs to a board that runs its own firmware. Load a pass-through program onto it that forwards all bytes to the servos, or use a servo adapter.</source>
        <translation>该端口属于一块运行自身程序的开发板。请在板上烧录透传程序，或使用舵机适配器。</translation>
    </message>
    <message>
        <source>%1 can be opened at %2 baud.</source>
        <translation>%1 能以波特率 %2 打开。</translation>
    </message>
    <message>
        <source>The adapter echoes what is sent; ServoDesk filters out the echo.</source>
        <translation>适配器会返回发送的内容（回显），ServoDesk 会将其滤除。</translation>
    </message>
    <message>
        <source>The adapter does not echo what is sent.</source>
        <translation>适配器不返回发送的内容（无回显）。</translation>
    </message>
    <message numerus="yes">
        <source>Nothing was received at any of the %n baud rate(s) tried.</source>
        <translation>
            <numerusform>已尝试 %n 个波特率，均未收到任何数据。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) received after a query to all servos at %1 baud: %2</source>
        <translation>
            <numerusform>以波特率 %1 查询所有舵机后收到 %n 个字节：%2</numerusform>
        </translation>
    </message>
    <message>
        <source>Text received at %1 baud: %2</source>
        <translation>以波特率 %1 收到文本：%2</translation>
    </message>
    <message>
        <source>At %1 baud, the line is never idle: a device is sending continuously.</source>
        <translation>波特率 %1 下线路一直没有空闲：有设备在不停发送。</translation>
    </message>
    <message>
        <source>The adapter does not support these baud rates: %1</source>
        <translation>适配器不支持以下波特率：%1</translation>
    </message>
    <message>
        <source>The baud rate of this port is set elsewhere, so no other rate could be tried.</source>
        <translation>该端口的波特率由其他设备设定，因此无法尝试其他波特率。</translation>
    </message>
    <message numerus="yes">
        <source>%n servo(s) found at %1 baud (%2): ID %3</source>
        <translation>
            <numerusform>以波特率 %1（%2）找到 %n 个舵机：ID %3</numerusform>
        </translation>
    </message>
    <message>
        <source>The slowest servo (ID %1) replies after %2 ms.</source>
        <translation>应答最慢的舵机（ID %1）用时 %2 毫秒。</translation>
    </message>
    <message>
        <source>ID %1: %2 of %3 replies were lost.</source>
        <translation>ID %1：%3 个应答中有 %2 个丢失。</translation>
    </message>
    <message>
        <source>ID %1: %2 of %3 replies were damaged.</source>
        <translation>ID %1：%3 个应答中有 %2 个损坏。</translation>
    </message>
    <message>
        <source>ID %1: %2 of %3 readings were damaged.</source>
        <translation>ID %1：%3 次读取中有 %2 次数据损坏。</translation>
    </message>
    <message>
        <source>ID %1: one request received several replies.</source>
        <translation>ID %1：一次请求收到多个应答。</translation>
    </message>
    <message>
        <source>ID %1: the readings cannot come from one servo.</source>
        <translation>ID %1：这些采样数据不可能来自同一个舵机。</translation>
    </message>
    <message>
        <source>ID %1 does not acknowledge writes.</source>
        <translation>ID %1 不应答写指令。</translation>
    </message>
    <message numerus="yes">
        <source>The replies to all %n test query(s) arrived undamaged.</source>
        <translation>
            <numerusform>%n 次测试查询的应答均无丢失或损坏。</numerusform>
        </translation>
    </message>
    <message>
        <source>Another program is also using the port.</source>
        <translation>另一个程序正在同时使用该端口。</translation>
    </message>
    <message>
        <source>Close the other program; otherwise, each program takes replies meant for the other.</source>
        <translation>请关闭另一个程序：两个程序会互相抢走对方的应答。</translation>
    </message>
    <message>
        <source>The port is also open in %1.</source>
        <translation>%1 也打开了该端口。</translation>
    </message>
    <message>
        <source>The latency timer of the adapter is set to %1 ms.</source>
        <translation>适配器的延迟计时器设为 %1 毫秒。</translation>
    </message>
    <message>
        <source>All servos reply without noticeable delay.</source>
        <translation>每个舵机都立即应答。</translation>
    </message>
    <message>
        <source>If a servo is missing, check its cable and power supply first. Then connect only that servo and run the diagnosis again; if no servo replies, the diagnosis tries more baud rates and protocols.</source>
        <translation>如果缺少某个舵机，请先检查它的导线和供电，然后只接这一个舵机重新诊断：没有舵机应答时会尝试更多波特率和协议。</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 分 %2 秒</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 小时 %2 分</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1，约剩 %2</translation>
    </message>
    <message>
        <source>with both angle limits at 0, the movement of the shaft is not limited</source>
        <translation>两个角度限制均为 0 时，输出轴的转动不受限制</translation>
    </message>
    <message>
        <source>Without limits, the shaft can turn past any position.</source>
        <translation>没有限制时，输出轴可转过任意位置。</translation>
    </message>
    <message>
        <source>A servo is in its bootloader and has no complete firmware.</source>
        <translation>有舵机停留在引导程序（bootloader）中，没有完整的固件。</translation>
    </message>
    <message>
        <source>The bootloader of a servo replies at %1 baud.</source>
        <translation>有舵机的引导程序在波特率 %1 下应答。</translation>
    </message>
    <message>
        <source>No other servo replies on this port.</source>
        <translation>此端口上没有其他舵机应答。</translation>
    </message>
    <message>
        <source>Other servos reply on this port: ID %1. They receive the firmware data too, and a second servo in its bootloader would store it.</source>
        <translation>此端口上还有其他舵机应答：ID %1。它们也会收到固件数据；如果另一个舵机也在引导程序中，会把固件写入自身。</translation>
    </message>
    <message>
        <source>The file name fits this model.</source>
        <translation>文件名与此型号相符。</translation>
    </message>
    <message>
        <source>No firmware file is known for this model, so the file name cannot be checked.</source>
        <translation>没有此型号的固件文件资料，因此无法核对文件名。</translation>
    </message>
    <message>
        <source>The file name does not fit this model; the vendor&apos;s file is named like %1.bin. Firmware for another model can make a servo unusable.</source>
        <translation>文件名与此型号不符；厂家的文件名类似 %1.bin。其他型号的固件可能使舵机无法使用。</translation>
    </message>
    <message>
        <source>The file has %1 bytes.</source>
        <translation>文件大小为 %1 字节。</translation>
    </message>
    <message>
        <source>Known servos have room for 29,696 bytes only.</source>
        <translation>已知的舵机只能容纳 29,696 字节。</translation>
    </message>
    <message>
        <source>The servo&apos;s supply voltage could not be measured.</source>
        <translation>无法测量舵机的电源电压。</translation>
    </message>
    <message>
        <source>The servo measures %1 V with torque off and on.</source>
        <translation>卸力和打开扭矩时，舵机测得 %1 V。</translation>
    </message>
    <message>
        <source>The servo measures %1 to %2 V with torque off and on.</source>
        <translation>卸力和打开扭矩时，舵机测得 %1 至 %2 V。</translation>
    </message>
    <message>
        <source>The supply must be steady and within the servo&apos;s limits.</source>
        <translation>电源必须稳定，且在舵机的限值之内。</translation>
    </message>
    <message>
        <source>The memory table is saved.</source>
        <translation>内存表已保存。</translation>
    </message>
    <message>
        <source>The memory table could not be saved (%1), so changed settings could not be restored.</source>
        <translation>内存表未能保存（%1），因此无法恢复发生变化的设置。</translation>
    </message>
    <message>
        <source>This computer has enough power.</source>
        <translation>本机电量充足。</translation>
    </message>
    <message>
        <source>This computer&apos;s battery has %1 % left. Connect the charger.</source>
        <translation>本机电池电量只剩 %1%。请接上充电器。</translation>
    </message>
    <message>
        <source>Other servos</source>
        <translation>其他舵机</translation>
    </message>
    <message>
        <source>File name</source>
        <translation>文件名</translation>
    </message>
    <message>
        <source>File size</source>
        <translation>文件大小</translation>
    </message>
    <message>
        <source>Power supply</source>
        <translation>电源</translation>
    </message>
    <message>
        <source>Memory table</source>
        <translation>内存表</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>电池</translation>
    </message>
    <message>
        <source>The servo runs the new firmware.</source>
        <translation>舵机已运行新固件。</translation>
    </message>
    <message>
        <source>The servo still has its old firmware.</source>
        <translation>舵机仍是原来的固件。</translation>
    </message>
    <message>
        <source>The servo has no complete firmware and is in its bootloader.</source>
        <translation>舵机没有完整的固件，停留在引导程序中。</translation>
    </message>
    <message>
        <source>Correct the cause, then update again.</source>
        <translation>请排除原因，然后重新更新。</translation>
    </message>
    <message>
        <source>We have not tried firmware updates on real servos yet; the steps are those published by others.</source>
        <translation>我们尚未在真实舵机上试过固件更新；步骤取自他人公开的资料。</translation>
    </message>
    <message>
        <source>the firmware of this servo cannot be updated here</source>
        <translation>无法在此更新这个舵机的固件</translation>
    </message>
    <message>
        <source>Only the bootloader of Feetech servos is known.</source>
        <translation>已知的只有飞特舵机的引导程序。</translation>
    </message>
    <message>
        <source>Use the manufacturer&apos;s software.</source>
        <translation>请使用厂家的软件。</translation>
    </message>
    <message>
        <source>this is not a firmware file for bus servos</source>
        <translation>这不是总线舵机的固件文件</translation>
    </message>
    <message>
        <source>Only *.bin files are for bus servos; *.hex, *.mbin, *.fbin and *.xbin are for other devices.</source>
        <translation>只有 *.bin 文件用于总线舵机；*.hex、*.mbin、*.fbin 和 *.xbin 用于其他设备。</translation>
    </message>
    <message>
        <source>Select the vendor&apos;s *.bin file for this model.</source>
        <translation>请选择厂家用于此型号的 *.bin 文件。</translation>
    </message>
    <message>
        <source>Download the file again.</source>
        <translation>请重新下载文件。</translation>
    </message>
    <message>
        <source>no bootloader has replied</source>
        <translation>没有引导程序应答</translation>
    </message>
    <message>
        <source>The servo&apos;s supply was not turned off and on in time, or the data wire is loose.</source>
        <translation>舵机的电源没有及时断开并重新接通，或数据线松动。</translation>
    </message>
    <message>
        <source>Start again, and turn the servo&apos;s supply off and on while the program waits.</source>
        <translation>请重新开始，并在程序等待时断开并重新接通舵机的电源。</translation>
    </message>
    <message>
        <source>Connect only this servo and rescue it with the same file.</source>
        <translation>请只连接这个舵机，用同一个文件救援它。</translation>
    </message>
    <message>
        <source>Its firmware update was probably interrupted. Connect only this servo and rescue it with the vendor&apos;s firmware file (Servo menu, Rescue firmware; servodesk-cli firmware rescue FILE).</source>
        <translation>可能是固件更新中断所致。只连接这个舵机，用厂家的固件文件救援（“舵机”菜单中的“救援固件”；servodesk-cli firmware rescue FILE）。</translation>
    </message>
    <message>
        <source>All settings are as before.</source>
        <translation>所有设置与更新前相同。</translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) changed with the firmware:</source>
        <translation>
            <numerusform>固件更新后有 %n 项设置发生变化：</numerusform>
        </translation>
    </message>
    <message>
        <source>It is not known whether the servo runs the new firmware.</source>
        <translation>无法确定舵机是否已运行新固件。</translation>
    </message>
    <message>
        <source>Turn the servo&apos;s supply off and on, search for it, and compare the versions. If it does not reply, rescue it with the same file.</source>
        <translation>断开并重新接通舵机的电源，然后搜索它并比较版本。如果没有应答，请用同一个文件救援。</translation>
    </message>
    <message>
        <source>several servos reply after the rescue</source>
        <translation>救援后有多个舵机应答</translation>
    </message>
    <message>
        <source>Compare the firmware versions of these servos.</source>
        <translation>请比较这些舵机的固件版本。</translation>
    </message>
    <message>
        <source>The memory table could not be read afterwards, so changed settings are not listed.</source>
        <translation>更新后未能读取内存表，因此没有列出发生变化的设置。</translation>
    </message>
    <message>
        <source>a servo replies, so the rescue cannot start</source>
        <translation>有舵机应答，因此救援无法开始</translation>
    </message>
    <message>
        <source>Another servo is connected, or the servo to rescue has its firmware.</source>
        <translation>还连接了其他舵机，或要救援的舵机固件完好。</translation>
    </message>
    <message>
        <source>Connect only the servo to rescue, and turn its supply off first.</source>
        <translation>请只连接要救援的舵机，并先断开它的电源。</translation>
    </message>
    <message>
        <source>Their supply came on together.</source>
        <translation>它们的电源同时接通。</translation>
    </message>
    <message>
        <source>this file does not have the size of a firmware file</source>
        <translation>此文件的大小不是固件文件应有的大小</translation>
    </message>
    <message>
        <source>A firmware file has 64 to 65,535 bytes.</source>
        <translation>固件文件的大小为 64 至 65,535 字节。</translation>
    </message>
    <message>
        <source>not moved yet</source>
        <translation>尚未转动</translation>
    </message>
    <message>
        <source>keep moving</source>
        <translation>请继续转动</translation>
    </message>
    <message>
        <source>range recorded</source>
        <translation>范围已采集</translation>
    </message>
    <message>
        <source>the range of this joint is not known</source>
        <translation>此关节的范围未知</translation>
    </message>
    <message>
        <source>The joint was not moved through its range.</source>
        <translation>关节没有转过整个范围。</translation>
    </message>
    <message>
        <source>Move the joint from stop to stop by hand.</source>
        <translation>请用手把关节从一个机械限位转到另一个机械限位。</translation>
    </message>
    <message>
        <source>the range does not fit into one turn of the encoder</source>
        <translation>范围超出编码器的一圈</translation>
    </message>
    <message>
        <source>this servo has no position limits</source>
        <translation>此舵机没有角度限制</translation>
    </message>
    <message>
        <source>Its family has no such registers.</source>
        <translation>该系列没有这些参数。</translation>
    </message>
    <message>
        <source>Leave the joint out of the arm.</source>
        <translation>请从机械臂中去掉此关节。</translation>
    </message>
    <message>
        <source>turns through a full turn</source>
        <translation>可转过一整圈</translation>
    </message>
    <message>
        <source>lost track: record again</source>
        <translation>位置跟踪中断：请重新采集</translation>
    </message>
    <message>
        <source>readings of this joint were missing while it moved</source>
        <translation>此关节转动时丢失了采样数据</translation>
    </message>
    <message>
        <source>It may have turned by half a turn meanwhile, so its range is not known.</source>
        <translation>其间可能转过了半圈，因此范围未知。</translation>
    </message>
    <message>
        <source>Record this joint again.</source>
        <translation>请重新采集此关节。</translation>
    </message>
    <message>
        <source>this joint turns through a full turn</source>
        <translation>此关节可转过一整圈</translation>
    </message>
    <message>
        <source>In this arm it has two stops: another servo has its ID, or the horn is loose.</source>
        <translation>在此机械臂中它有两个机械限位：可能其他舵机占用了其 ID，或舵盘松动。</translation>
    </message>
    <message>
        <source>Check the IDs and the horn, or make the joint continuous in a file of your own.</source>
        <translation>请检查 ID 和舵盘，或在自己的机械臂文件中把此关节设为 continuous。</translation>
    </message>
    <message>
        <source>this joint is in step mode and reports no position</source>
        <translation>此关节处于步进模式，不反馈位置</translation>
    </message>
    <message>
        <source>Another program has set the mode.</source>
        <translation>该模式由其他程序设置。</translation>
    </message>
    <message>
        <source>Set the position mode first.</source>
        <translation>请先设为位置模式。</translation>
    </message>
    <message>
        <source>this servo cannot hold the offset or the limits</source>
        <translation>此舵机无法保存该位置校正或角度限制</translation>
    </message>
    <message>
        <source>The file is for another arm, or for other servos.</source>
        <translation>文件属于其他机械臂或其他舵机。</translation>
    </message>
    <message>
        <source>Calibrate the arm, or select another file.</source>
        <translation>请校准机械臂，或选择其他文件。</translation>
    </message>
    <message>
        <source>The middle pose is too far from the middle of the range.</source>
        <translation>结束时的姿态离范围中点太远。</translation>
    </message>
    <message>
        <source>End in a pose closer to the middle, or use the middle of the range.</source>
        <translation>请在更接近中点的姿态结束，或使用范围中点。</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>移动中</translation>
    </message>
    <message>
        <source>reached both ends</source>
        <translation>已到达两端</translation>
    </message>
    <message>
        <source>alarm while moving</source>
        <translation>运动中报警</translation>
    </message>
    <message>
        <source>No reply from %1.</source>
        <translation>%1 无应答。</translation>
    </message>
    <message>
        <source>The firmware versions differ: LeRobot refuses the bus.</source>
        <translation>固件版本不一致：LeRobot 会拒绝连接。</translation>
    </message>
    <message>
        <source>The EPROM lock is open (ID %1), as LeRobot leaves it when it turns torque off.</source>
        <translation>EPROM 未上锁（ID %1）：LeRobot 卸力后会让 EPROM 保持未上锁状态。</translation>
    </message>
    <message>
        <source>LeRobot would change settings at its next start (ID %1).</source>
        <translation>LeRobot 下次启动时会修改参数（ID %1）。</translation>
    </message>
    <message>
        <source>the torque of this servo cannot be limited</source>
        <translation>无法限制该舵机的扭矩</translation>
    </message>
    <message>
        <source>Its family has no such register.</source>
        <translation>该系列没有此参数。</translation>
    </message>
    <message>
        <source>Leave the joint out of the move test.</source>
        <translation>请不要在运动测试中包含该关节。</translation>
    </message>
    <message>
        <source>end not reached</source>
        <translation>未到达端点</translation>
    </message>
    <message>
        <source>no longer takes goals</source>
        <translation>不再接受目标位置</translation>
    </message>
    <message>
        <source>no LeRobot settings are known for this family</source>
        <translation>没有该系列的 LeRobot 参数</translation>
    </message>
    <message>
        <source>Only those of STS and SMS servos are known.</source>
        <translation>只有 STS 和 SMS 舵机的参数。</translation>
    </message>
    <message>
        <source>%1 has the model %2; LeRobot expects %3 and refuses the bus. Fit that model, or enter %2 both in the arm and in LeRobot&apos;s code.</source>
        <translation>%1 的型号是 %2；LeRobot 要求 %3，会拒绝连接。请换成 %3，或在机械臂定义和 LeRobot 代码中都填 %2。</translation>
    </message>
</context>
<context>
    <name>ui</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
</context>
<context>
    <name>ui::AboutDialog</name>
    <message>
        <source>About ServoDesk</source>
        <translation>关于 ServoDesk</translation>
    </message>
    <message>
        <source>Setup and test program for serial bus servos: Feetech SCS, STS, SMS and HLS, SMS over Modbus-RTU, and Hiwonder LX.</source>
        <translation>串行总线舵机调试程序：飞特 SCS、STS、SMS、HLS，SMS 的 Modbus-RTU 协议，以及幻尔 LX。</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later, without any warranty. Icons: Breeze, by the KDE Visual Design Group, LGPL 3 or later. Built with Qt %1.</source>
        <translation>自由软件，遵循 GNU 通用公共许可证第 3 版或更高版本，不提供任何担保。图标：KDE Visual Design Group 的 Breeze，LGPL 3 或更高版本。使用 Qt %1 构建。</translation>
    </message>
    <message>
        <source>Journal and snapshots: %1</source>
        <translation>写入日志与快照：%1</translation>
    </message>
    <message>
        <source>Your own servo models (JSON files): %1</source>
        <translation>自定义舵机型号（JSON 文件）：%1</translation>
    </message>
</context>
<context>
    <name>ui::AllowMovementButton</name>
    <message>
        <source>Turn torque on?</source>
        <translation>打开扭矩？</translation>
    </message>
    <message>
        <source>The emergency stop turned torque off for %1. Torque will be turned on again at the servos&apos; present positions; nothing moves until you start a test.</source>
        <translation>急停已让 %1 卸力。将在舵机当前位置重新打开扭矩；在您开始测试之前，舵机不会运动。</translation>
    </message>
    <message>
        <source>Keep hands and objects away from the servos. Esc immediately turns torque off on all servos.</source>
        <translation>请让双手和物体远离舵机的运动范围。按 Esc 立即让所有舵机卸力。</translation>
    </message>
    <message>
        <source>Turn torque on</source>
        <translation>打开扭矩</translation>
    </message>
    <message>
        <source>Torque was not turned on.</source>
        <translation>扭矩未打开。</translation>
    </message>
    <message>
        <source>Wait until the search or test has ended, then click “Allow movement” again.</source>
        <translation>请等搜索或测试结束，再点击“允许运动”。</translation>
    </message>
    <message>
        <source>Allow movement</source>
        <translation>允许运动</translation>
    </message>
    <message>
        <source>Turns torque on after the emergency stop; nothing moves yet</source>
        <translation>急停后重新打开扭矩；此时舵机不会运动</translation>
    </message>
</context>
<context>
    <name>ui::AppearanceButtons</name>
    <message>
        <source>Switches between English and Chinese</source>
        <translation>在中文和英文之间切换</translation>
    </message>
    <message>
        <source>Switches between English and Chinese; no Chinese font is installed (Debian: fonts-noto-cjk)</source>
        <translation>在中文和英文之间切换；系统没有安装中文字体（Debian：fonts-noto-cjk）</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Switches between the light and dark themes</source>
        <translation>在浅色和深色主题之间切换</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
</context>
<context>
    <name>ui::ApplyDialog</name>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>Restore a bundle</source>
        <translation>恢复整组快照</translation>
    </message>
    <message>
        <source>Apply to several servos</source>
        <translation>应用到多个舵机</translation>
    </message>
    <message>
        <source>Servos</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行数</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>预演</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Save result…</source>
        <translation>保存结果…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Nothing was written. Each servo&apos;s tooltip lists the rows that would be written.</source>
        <translation>未写入任何内容。将鼠标指针停在列表中的舵机上，可查看将要写入的行。</translation>
    </message>
    <message>
        <source>Save the result</source>
        <translation>保存结果</translation>
    </message>
    <message>
        <source>Data (*.json)</source>
        <translation>数据 (*.json)</translation>
    </message>
    <message>
        <source>would cause an alarm now</source>
        <translation>会立即引起报警</translation>
    </message>
    <message>
        <source>old values not restored</source>
        <translation>未能恢复原值</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) skipped</source>
        <translation>
            <numerusform>跳过 %n 行</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1”: each servo gets its own snapshot, matched by ID. IDs and baud rates are never written here.</source>
        <translation>“%1”：按 ID 将快照写回对应的舵机。这里绝不写入 ID 和波特率。</translation>
    </message>
    <message>
        <source>“%1”: each selected servo is read, and only the rows that differ are written. IDs and baud rates are never written here.</source>
        <translation>“%1”：逐个读取已勾选的舵机，只写入有差异的行。这里绝不写入 ID 和波特率。</translation>
    </message>
    <message>
        <source>If a row fails, restore that servo&apos;s old values</source>
        <translation>如果某行写入失败，则恢复该舵机的原值</translation>
    </message>
    <message>
        <source>If this option is not selected, writing to a servo stops at the failed row; values already written stay in the servo</source>
        <translation>不勾选时，遇到写入失败的行即停止写入该舵机，已写入的值保留在舵机中</translation>
    </message>
    <message>
        <source>Include IDs that now belong to another model</source>
        <translation>包括现已换成其他型号的 ID</translation>
    </message>
    <message>
        <source>Matches registers by name; registers without a match are skipped and listed</source>
        <translation>按参数名对应；无法对应的参数会跳过并列出</translation>
    </message>
    <message>
        <source>Include dangerous rows</source>
        <translation>同时写入危险项</translation>
    </message>
    <message>
        <source>Also writes rows where a wrong value can make a servo unreachable</source>
        <translation>同时写入危险项（数值有误时舵机可能失联）</translation>
    </message>
    <message>
        <source>Reads the servos and shows what would be written to each</source>
        <translation>读取各舵机并显示将要写入的内容</translation>
    </message>
    <message>
        <source>Writes the differing rows to each selected servo</source>
        <translation>把有差异的行写入每个已勾选的舵机</translation>
    </message>
    <message>
        <source>Stops after finishing the current servo</source>
        <translation>写完当前舵机后停止</translation>
    </message>
    <message>
        <source>Saves the result for each row to a file</source>
        <translation>把每一行的结果保存为文件</translation>
    </message>
    <message>
        <source>Closes this window</source>
        <translation>关闭此窗口</translation>
    </message>
    <message numerus="yes">
        <source>Write to %n servo(s)?</source>
        <translation>
            <numerusform>写入 %n 个舵机？</numerusform>
        </translation>
    </message>
    <message>
        <source>Torque will be turned off on each servo before writing and will stay off.</source>
        <translation>每个舵机写入前都会先卸力，并保持卸力。</translation>
    </message>
    <message>
        <source>Dangerous rows are selected: a wrong value can make a servo unreachable.</source>
        <translation>已勾选的行中有危险项：错误的值可能使舵机失联。</translation>
    </message>
    <message>
        <source>The operation failed for %1 of %2 servos; their tooltips show the reason.</source>
        <translation>%2 个舵机中有 %1 个未成功；原因见各行提示。</translation>
    </message>
    <message>
        <source>Written, but rows were skipped on %1 of %2 servos; their tooltips show which rows and why.</source>
        <translation>已写入，但 %2 个舵机中有 %1 个跳过了部分参数；跳过的参数及原因见各舵机的提示。</translation>
    </message>
    <message>
        <source>All %1 servos match the snapshot.</source>
        <translation>全部 %1 个舵机已与快照一致。</translation>
    </message>
    <message>
        <source>Table for spreadsheets (*.csv)</source>
        <translation>电子表格 (*.csv)</translation>
    </message>
</context>
<context>
    <name>ui::ArmChoice</name>
    <message>
        <source>From file…</source>
        <translation>从文件…</translation>
    </message>
    <message>
        <source>New arm…</source>
        <translation>新建机械臂…</translation>
    </message>
    <message>
        <source>Select the file with the arm</source>
        <translation>选择机械臂文件</translation>
    </message>
    <message>
        <source>Robot arms (*.json)</source>
        <translation>机械臂 (*.json)</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>机械臂</translation>
    </message>
    <message>
        <source>Selects which joints the arm has</source>
        <translation>选择机械臂有哪些关节</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>编辑…</translation>
    </message>
    <message>
        <source>Changes the joints of the arm and saves them to a file</source>
        <translation>修改机械臂的关节并保存到文件</translation>
    </message>
</context>
<context>
    <name>ui::ArmDialog</name>
    <message>
        <source>between two stops</source>
        <translation>有两个机械限位</translation>
    </message>
    <message>
        <source>continuous</source>
        <translation>连续旋转</translation>
    </message>
    <message>
        <source>gripper</source>
        <translation>夹爪</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>轮子</translation>
    </message>
    <message>
        <source>The joint with ID %1 has no name.</source>
        <translation>ID %1 的关节没有名称。</translation>
    </message>
    <message>
        <source>Two joints have the name %1.</source>
        <translation>有两个关节名为 %1。</translation>
    </message>
    <message>
        <source>Two joints have the ID %1.</source>
        <translation>有两个关节的 ID 为 %1。</translation>
    </message>
    <message>
        <source>The arm has no joints.</source>
        <translation>该机械臂没有关节。</translation>
    </message>
    <message>
        <source>Save the arm</source>
        <translation>保存机械臂</translation>
    </message>
    <message>
        <source>Robot arms (*.json)</source>
        <translation>机械臂 (*.json)</translation>
    </message>
    <message>
        <source>Edit arm</source>
        <translation>编辑机械臂</translation>
    </message>
    <message>
        <source>The joints of the arm, each with the ID of its servo. Names are those of LeRobot&apos;s calibration file. Reversed joints turn the other way in LeRobot (drive_mode); no register changes.</source>
        <translation>机械臂的关节及其舵机的 ID。名称与 LeRobot 校准文件中的一致。反向的关节在 LeRobot 中反方向转动（drive_mode），不修改任何参数。</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>机械臂</translation>
    </message>
    <message>
        <source>Shown in the list of arms</source>
        <translation>显示在机械臂列表中</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Reversed</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>One row per joint; an empty model means any</source>
        <translation>每个关节一行；型号为空表示任意型号</translation>
    </message>
    <message>
        <source>Add joint</source>
        <translation>添加关节</translation>
    </message>
    <message>
        <source>Adds a joint with the next ID</source>
        <translation>添加一个使用下一个 ID 的关节</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Removes the selected joints from the arm</source>
        <translation>从机械臂中移除所选关节</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Saves the arm to a file and selects it</source>
        <translation>将机械臂保存到文件并选用</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Closes without a change</source>
        <translation>关闭，不做修改</translation>
    </message>
    <message>
        <source>%1: an ID is a number from 0 to 253.</source>
        <translation>%1：ID 应为 0 到 253 之间的数字。</translation>
    </message>
    <message>
        <source>Leader: moved by hand only</source>
        <translation>主臂：只用手转动</translation>
    </message>
    <message>
        <source>LeRobot sets neither gains nor gripper limits of a leader</source>
        <translation>LeRobot 不设置主臂的增益和夹爪限制</translation>
    </message>
    <message>
        <source>New arm</source>
        <translation>新建机械臂</translation>
    </message>
</context>
<context>
    <name>ui::ArmModel</name>
    <message>
        <source>not in the list</source>
        <translation>不在列表中</translation>
    </message>
    <message>
        <source>%1 instead of %2</source>
        <translation>是 %1，应为 %2</translation>
    </message>
    <message>
        <source>wheel: not calibrated</source>
        <translation>轮子：不校准</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>位置校正</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>行程</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>joint, changes</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>ui::ArmPage</name>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>Turn torque off?</source>
        <translation>卸力？</translation>
    </message>
    <message>
        <source>The joints are then moved by hand while their positions are recorded. Nothing else is written.</source>
        <translation>随后用手转动关节，同时采集位置。不写入其他内容。</translation>
    </message>
    <message>
        <source>The arm drops when torque goes off: hold it.</source>
        <translation>卸力时机械臂会落下：请扶住。</translation>
    </message>
    <message>
        <source>Torque off</source>
        <translation>卸力</translation>
    </message>
    <message numerus="yes">
        <source>Write offset and limits of %n joint(s)?</source>
        <translation>
            <numerusform>写入 %n 个关节的位置校正和角度限制？</numerusform>
        </translation>
    </message>
    <message>
        <source>The memory tables are saved first, and every value is read back. Torque stays off.</source>
        <translation>先保存内存表，每个值写入后都会回读。舵机保持卸力。</translation>
    </message>
    <message>
        <source>The offset shifts the zero position of a joint.</source>
        <translation>位置校正会移动关节的零位。</translation>
    </message>
    <message>
        <source>Write to servos</source>
        <translation>写入舵机</translation>
    </message>
    <message>
        <source>Not all joints could be written: ID %1</source>
        <translation>有关节未能写入：ID %1</translation>
    </message>
    <message>
        <source>Torque is off. Move every joint from stop to stop, in any order. The encoder&apos;s seam may lie anywhere in the range. Click Continue when every joint is recorded.</source>
        <translation>已卸力。以任意顺序把每个关节从一个机械限位转到另一个机械限位。编码器零点（4095 与 0 的交界）可以在范围内的任何位置。采集完所有关节后点击“继续”。</translation>
    </message>
    <message>
        <source>Nothing has been written yet. Check the new offsets and limits, then write them to the servos. Joints that were not recorded stay as they are.</source>
        <translation>尚未写入。请检查新的位置校正和角度限制，然后写入舵机。未采集的关节保持不变。</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>正在写入…</translation>
    </message>
    <message>
        <source>Not in the list of servos: %1. Search the bus, or select another arm.</source>
        <translation>不在舵机列表中：%1。请搜索总线，或选择其他机械臂。</translation>
    </message>
    <message>
        <source>Record ranges…</source>
        <translation>采集范围…</translation>
    </message>
    <message>
        <source>Turns torque off after a question and records how far joints are moved</source>
        <translation>确认后卸力，并采集关节转动的范围</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Ends the recording and shows the new offsets and limits</source>
        <translation>结束采集并显示新的位置校正和角度限制</translation>
    </message>
    <message>
        <source>Write to servos…</source>
        <translation>写入舵机…</translation>
    </message>
    <message>
        <source>Writes the new offsets and limits after a question</source>
        <translation>确认后写入新的位置校正和角度限制</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>机械臂</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Last pose is the middle</source>
        <translation>以最后姿态为中位</translation>
    </message>
    <message>
        <source>Uses the pose in which you click Continue as the middle, instead of the middle of each range</source>
        <translation>以点击“继续”时的姿态作为中位，而不是各范围的中点</translation>
    </message>
    <message>
        <source>Only the selected joints: %1.</source>
        <translation>仅所选关节：%1。</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s) written and read back.</source>
        <translation>
            <numerusform>%n 个关节已写入并回读。</numerusform>
        </translation>
    </message>
    <message>
        <source>Write these joints again.</source>
        <translation>请重新写入这些关节。</translation>
    </message>
    <message>
        <source>Move at %1 % torque</source>
        <translation>以 %1% 扭矩运动</translation>
    </message>
    <message>
        <source>Move the joints to their limits?</source>
        <translation>让关节运动到角度限制？</translation>
    </message>
    <message>
        <source>One joint after the other turns torque on, moves slowly to both ends of its limits and back, and turns torque off. With little torque a heavy arm may not get there.</source>
        <translation>各关节依次打开扭矩，缓慢运动到角度限制的两端并返回，然后卸力。扭矩较小时，较重的机械臂可能无法到达。</translation>
    </message>
    <message>
        <source>The arm moves: keep hands and objects away, and hold what would drop.</source>
        <translation>机械臂会运动：请勿靠近，移开障碍物，并扶住可能下落的部分。</translation>
    </message>
    <message>
        <source>For a heavy arm</source>
        <translation>用于较重的机械臂</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s) reached both ends.</source>
        <translation>
            <numerusform>%n 个关节已到达两端。</numerusform>
        </translation>
    </message>
    <message>
        <source>Not at both ends: %1</source>
        <translation>未到达两端：%1</translation>
    </message>
    <message>
        <source>Something is in the way, the limits are beyond a mechanical stop, or the torque is too little.</source>
        <translation>有障碍物、角度限制超出机械限位，或扭矩不足。</translation>
    </message>
    <message>
        <source>Clear the range and test again with more torque, or calibrate these joints again.</source>
        <translation>请清除障碍物后以更大扭矩重新测试，或重新校准这些关节。</translation>
    </message>
    <message>
        <source>The joints move one after the other. Esc turns torque off at once.</source>
        <translation>各关节依次运动。按 Esc 立即卸力。</translation>
    </message>
    <message>
        <source>Hold the arm and turn its torque off, then move every joint through its range. The middle of each range becomes 2048, and its ends become the limits. Select rows to record or test only these joints.</source>
        <translation>扶住机械臂并卸力，然后将每个关节转过其全部范围。各范围的中点将变为 2048，两端成为角度限制。选中若干行则只采集或测试这些关节。</translation>
    </message>
    <message numerus="yes">
        <source>Test %n joint(s)…</source>
        <translation>
            <numerusform>测试 %n 个关节…</numerusform>
        </translation>
    </message>
    <message>
        <source>Test moves…</source>
        <translation>运动测试…</translation>
    </message>
    <message>
        <source>Moves the joints to both ends of their limits, slowly and with little torque, after a question</source>
        <translation>确认后让关节以低速、小扭矩运动到角度限制的两端</translation>
    </message>
    <message numerus="yes">
        <source>Record %n joint(s)…</source>
        <translation>
            <numerusform>采集 %n 个关节…</numerusform>
        </translation>
    </message>
    <message>
        <source>One row per joint of the arm; select rows to record or test only these</source>
        <translation>机械臂的每个关节一行；选中若干行则只采集或测试这些关节</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>joint, result</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>The move test has ended there.</source>
        <translation>运动测试到此结束。</translation>
    </message>
    <message>
        <source>Check the servo&apos;s alarms and supply.</source>
        <translation>请检查舵机的报警和供电。</translation>
    </message>
    <message numerus="yes">
        <source>Stopped after %n joint(s), which reached both ends.</source>
        <translation>
            <numerusform>已停止；之前有 %n 个关节到达两端。</numerusform>
        </translation>
    </message>
    <message>
        <source>Ends the recording or the test; the servos keep their offsets and limits</source>
        <translation>结束采集或测试；舵机保持原有的位置校正和角度限制</translation>
    </message>
    <message>
        <source>Not calibrated, so these run into their mechanical stops: %1.</source>
        <translation>未校准，会撞到机械限位：%1。</translation>
    </message>
    <message>
        <source>Undo takes back one joint at a time, the last one first.</source>
        <translation>“撤销”每次还原一个关节，从最后写入的关节开始。</translation>
    </message>
</context>
<context>
    <name>ui::Banner</name>
    <message>
        <source>Close this message</source>
        <translation>关闭此消息</translation>
    </message>
</context>
<context>
    <name>ui::BitsEditor</name>
    <message>
        <source>bit %1, unnamed</source>
        <translation>位 %1（未命名）</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Bit %1, adds %2 to the value</source>
        <translation>位 %1，勾选后数值加 %2</translation>
    </message>
    <message>
        <source>The sum of the selected bits. %1</source>
        <translation>已勾选位的数值之和。%1</translation>
    </message>
    <message>
        <source>Bit %1, adds %2 to the value; not named in the data sheet, so it is kept unchanged</source>
        <translation>位 %1，勾选后数值加 %2；规格书中没有命名，因此保持原样</translation>
    </message>
</context>
<context>
    <name>ui::ChannelsDialog</name>
    <message>
        <source>The selected servo</source>
        <translation>所选舵机</translation>
    </message>
    <message>
        <source>ID %1 · %2</source>
        <translation>ID %1 · %2</translation>
    </message>
    <message>
        <source>Find a register</source>
        <translation>查找参数</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Part of the register name</source>
        <translation>参数名称的一部分</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Selected registers are read and shown</source>
        <translation>读取并显示勾选的参数</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Color of the selected channel</source>
        <translation>所选通道的颜色</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>倍数</translation>
    </message>
    <message>
        <source>Drawn as value × scale + offset; cursors show the actual value</source>
        <translation>曲线按“数值 × 倍数 + 偏移”绘制；游标显示实际值</translation>
    </message>
    <message>
        <source>Added to the drawn value, in the same unit</source>
        <translation>绘制时加到数值上，单位与数值相同</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Shows the goal, position, speed and current of the selected servo</source>
        <translation>显示所选舵机的目标、位置、速度和电流</translation>
    </message>
    <message>
        <source>Closes this list and keeps the channels</source>
        <translation>关闭列表，通道保留</translation>
    </message>
</context>
<context>
    <name>ui::CloseConfirmation</name>
    <message>
        <source>Servo %1 is turning. Stop it before closing?</source>
        <translation>舵机 %1 正在转动。是否先停止转动，再关闭程序？</translation>
    </message>
    <message>
        <source>Servos %1 are turning. Stop them before closing?</source>
        <translation>舵机 %1 正在转动。是否先停止转动，再关闭程序？</translation>
    </message>
    <message>
        <source>Servo %1 is turning. Stop it before disconnecting?</source>
        <translation>舵机 %1 正在转动。是否先停止转动，再断开连接？</translation>
    </message>
    <message>
        <source>Servos %1 are turning. Stop them before disconnecting?</source>
        <translation>舵机 %1 正在转动。是否先停止转动，再断开连接？</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>停止并关闭</translation>
    </message>
    <message>
        <source>Stop and disconnect</source>
        <translation>停止并断开连接</translation>
    </message>
    <message>
        <source>A test is running. Stop it and close?</source>
        <translation>测试正在运行。停止测试并关闭程序？</translation>
    </message>
    <message>
        <source>A test is running. Stop it and disconnect?</source>
        <translation>测试正在运行。停止测试并断开连接？</translation>
    </message>
    <message>
        <source>The servos will then hold their position with torque on.</source>
        <translation>之后舵机将保持当前位置，扭矩处于打开状态。</translation>
    </message>
    <message>
        <source>A write is unfinished. Close anyway?</source>
        <translation>有一项更改未写完。仍要关闭程序吗？</translation>
    </message>
    <message>
        <source>A write is unfinished. Disconnect anyway?</source>
        <translation>有一项更改未写完。仍要断开连接吗？</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>断开</translation>
    </message>
    <message>
        <source>Lock and close</source>
        <translation>上锁并关闭</translation>
    </message>
    <message>
        <source>Lock and disconnect</source>
        <translation>上锁并断开连接</translation>
    </message>
    <message>
        <source>Torque will then be turned off.</source>
        <translation>之后舵机将卸力。</translation>
    </message>
    <message>
        <source>ID %1: the unfinished write is recorded in the journal. The next time you connect, ServoDesk will offer to finish or undo it.</source>
        <translation>ID %1：未写完的更改已记入写入日志。下次连接时可选择完成或撤销。</translation>
    </message>
    <message>
        <source>The EPROM of ID %1 is unlocked. It will be locked first.</source>
        <translation>ID %1 的 EPROM 未上锁，将先上锁。</translation>
    </message>
    <message>
        <source>The EPROM of ID %1 is unlocked and cannot be locked now.</source>
        <translation>ID %1 的 EPROM 未上锁，现在无法上锁。</translation>
    </message>
    <message>
        <source>The EPROM of the servo with ID %1 was unlocked, and ServoDesk could not confirm that it was locked again.</source>
        <translation>舵机（ID %1）的 EPROM 曾解锁，ServoDesk 未能确认是否已重新上锁。</translation>
    </message>
    <message>
        <source>Leave unlocked</source>
        <translation>不上锁</translation>
    </message>
    <message>
        <source>The EPROM stays unlocked, so settings written by any program are kept after power-off.</source>
        <translation>EPROM 不会上锁，因此任何程序写入的设置断电后仍会保留。</translation>
    </message>
    <message>
        <source>Once stopped, a servo keeps its torque on if it can hold its position.</source>
        <translation>停止后，如果舵机能保持位置，则扭矩保持打开。</translation>
    </message>
    <message>
        <source>If not stopped now, the servo will keep turning, and ServoDesk will no longer be able to stop it.</source>
        <translation>如果现在不停止，舵机会一直转动，之后 ServoDesk 无法再让其停止。</translation>
    </message>
    <message>
        <source>If not stopped now, the servo will continue to its goal, and ServoDesk will no longer be able to stop it.</source>
        <translation>如果现在不停止，舵机会一直转到目标位置，之后 ServoDesk 无法再让其停止。</translation>
    </message>
    <message>
        <source>Do not stop</source>
        <translation>不停止</translation>
    </message>
</context>
<context>
    <name>ui::Commands</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>ui::CommissionBatchView</name>
    <message>
        <source>Servos in the batch</source>
        <translation>批次中的舵机</translation>
    </message>
    <message>
        <source>One row per servo, as in the batch file</source>
        <translation>每个舵机一行，与批次文件一致</translation>
    </message>
    <message>
        <source>Copy labels</source>
        <translation>复制标签</translation>
    </message>
    <message>
        <source>Copies the labels of the selected servos, or of all servos if none is selected, one per line</source>
        <translation>复制所选舵机的标签（未选择时复制全部），每行一个</translation>
    </message>
    <message>
        <source>Next IDs: %1</source>
        <translation>待分配 ID：%1</translation>
    </message>
    <message>
        <source>Servos</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>No servo has been set up yet. Click Start, then connect the first servo.</source>
        <translation>尚未设置任何舵机。点击“开始”，然后连接第一个舵机。</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>已完成 %1 个</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>失败 %1 个</translation>
    </message>
    <message>
        <source>%1 set aside</source>
        <translation>剔除 %1 个</translation>
    </message>
    <message>
        <source>%1 unfinished</source>
        <translation>未完成 %1 个</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>保存报告…</translation>
    </message>
    <message>
        <source>Saves the batch as a report to hand over with the servos</source>
        <translation>将批次保存为可随舵机交付的报告</translation>
    </message>
    <message numerus="yes">
        <source>%1 (%n ID(s))</source>
        <translation>
            <numerusform>%1（共 %n 个）</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::CommissionForm</name>
    <message>
        <source>Template</source>
        <translation>模板</translation>
    </message>
    <message>
        <source>Snapshots and templates (*.json)</source>
        <translation>快照和模板 (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>批次</translation>
    </message>
    <message>
        <source>Batch files (*.csv)</source>
        <translation>批次文件 (*.csv)</translation>
    </message>
    <message>
        <source>Specify the batch file.</source>
        <translation>请指定批次文件。</translation>
    </message>
    <message>
        <source>The file name contains a character that is not allowed.</source>
        <translation>文件名中含有不允许的字符。</translation>
    </message>
    <message>
        <source>The last ID must not be lower than the first ID.</source>
        <translation>结束 ID 不能小于起始 ID。</translation>
    </message>
    <message>
        <source>A wrong value in these rows can make a servo unreachable or dangerous: %1</source>
        <translation>以下各项的数值错误可能导致舵机失联或造成危险：%1</translation>
    </message>
    <message>
        <source>Batch file (CSV); an existing batch is resumed</source>
        <translation>批次文件（CSV）；如果是已有批次，将继续该批次</translation>
    </message>
    <message>
        <source>Snapshot or template written to every servo; leave empty for none</source>
        <translation>写入每个舵机的快照或模板；留空表示不写</translation>
    </message>
    <message>
        <source>First ID</source>
        <translation>起始 ID</translation>
    </message>
    <message>
        <source>ID of the first servo; each later servo gets the next ID</source>
        <translation>第一个舵机的 ID，之后依次递增</translation>
    </message>
    <message>
        <source>Last ID</source>
        <translation>结束 ID</translation>
    </message>
    <message>
        <source>Commissioning ends when this ID has been assigned</source>
        <translation>分配完此 ID 后，批量设置结束</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>Baud rate to set on every servo</source>
        <translation>写入每个舵机的波特率</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Label text, with placeholders: {model} {id} {rate} {baud} {firmware} {date} {was_id}</source>
        <translation>标签文字，可含占位符：{model} {id} {rate} {baud} {firmware} {date} {was_id}</translation>
    </message>
    <message>
        <source>Select the batch file</source>
        <translation>选择批次文件</translation>
    </message>
    <message>
        <source>Select the template</source>
        <translation>选择模板</translation>
    </message>
    <message>
        <source>Unchanged</source>
        <translation>保持不变</translation>
    </message>
    <message>
        <source>Set the present position as the midpoint</source>
        <translation>把当前位置设为中位</translation>
    </message>
    <message>
        <source>Only for servos with a command to set the midpoint; move the horn to the midpoint first</source>
        <translation>仅适用于带“设为中位”指令的舵机；请先将舵盘摆到中位</translation>
    </message>
    <message>
        <source>Set up without confirmation</source>
        <translation>自动设置，不逐个确认</translation>
    </message>
    <message>
        <source>Sets up each servo without asking; servos with an alarm or another problem are set aside</source>
        <translation>设置每个舵机时不再询问；有报警或其他问题的舵机会被剔除</translation>
    </message>
    <message>
        <source>Include the template&apos;s dangerous rows</source>
        <translation>同时写入模板中的危险项</translation>
    </message>
</context>
<context>
    <name>ui::CommissionModel</name>
    <message>
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>电压</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Nothing was written</source>
        <translation>未写入任何内容</translation>
    </message>
    <message>
        <source>Memory table saved before the first write: %1</source>
        <translation>首次写入前的内存表已保存：%1</translation>
    </message>
    <message>
        <source>ID and baud rate of the servo when connected</source>
        <translation>舵机接上时的 ID 和波特率</translation>
    </message>
    <message>
        <source>ID and baud rate given to the servo</source>
        <translation>设置后的 ID 和波特率</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Settings written</source>
        <translation>写入项数</translation>
    </message>
</context>
<context>
    <name>ui::CommissionPage</name>
    <message>
        <source>Connect to a port first.</source>
        <translation>请先连接端口。</translation>
    </message>
    <message>
        <source>Connect the next servo</source>
        <translation>接上下一个舵机</translation>
    </message>
    <message>
        <source>Commissioning</source>
        <translation>批量设置</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Write dangerous rows to every servo?</source>
        <translation>向每个舵机写入危险项？</translation>
    </message>
    <message>
        <source>The template contains: %1</source>
        <translation>模板中包含：%1</translation>
    </message>
    <message>
        <source>Write anyway</source>
        <translation>仍要写入</translation>
    </message>
    <message>
        <source>The template cannot be read.</source>
        <translation>无法读取模板。</translation>
    </message>
    <message>
        <source>A wrong value can make a servo unreachable or dangerous, and these rows will be written to every servo in the batch.</source>
        <translation>数值错误可能导致舵机失联或造成危险；这些危险项会写入本批次的每个舵机。</translation>
    </message>
    <message>
        <source>The batch cannot be resumed.</source>
        <translation>此批次无法继续。</translation>
    </message>
    <message>
        <source>A search is running; commissioning can start after the search has ended.</source>
        <translation>正在搜索，搜索结束后即可开始批量设置。</translation>
    </message>
    <message>
        <source>A test is running.</source>
        <translation>正在进行测试。</translation>
    </message>
    <message>
        <source>Waits for the first servo, or resumes the batch</source>
        <translation>等待第一个舵机，或继续该批次</translation>
    </message>
    <message>
        <source>Ends commissioning; the batch can be resumed at any time</source>
        <translation>结束批量设置；之后可随时继续该批次</translation>
    </message>
    <message>
        <source>Connects the next simulated servo</source>
        <translation>接上下一个模拟舵机</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>拔下</translation>
    </message>
    <message>
        <source>Disconnects the current simulated servo</source>
        <translation>拔下当前接上的模拟舵机</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>Printable page (*.pdf)</source>
        <translation>可打印页面 (*.pdf)</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
</context>
<context>
    <name>ui::CommissionStatus</name>
    <message>
        <source>Commissioning has ended</source>
        <translation>批量设置已结束</translation>
    </message>
    <message>
        <source>One servo at a time</source>
        <translation>逐个接上并设置舵机</translation>
    </message>
    <message>
        <source>Connect the same servo again</source>
        <translation>请重新接上同一个舵机</translation>
    </message>
    <message>
        <source>Connect the next servo</source>
        <translation>接上下一个舵机</translation>
    </message>
    <message>
        <source>Several servos are replying: disconnect all but one</source>
        <translation>有多个舵机应答：请拔下其余舵机，只留一个</translation>
    </message>
    <message>
        <source>Two servos with the same ID: disconnect one</source>
        <translation>两个舵机 ID 相同：请拔下其中一个</translation>
    </message>
    <message>
        <source>A servo is replying but cannot be identified</source>
        <translation>有舵机应答，但无法识别</translation>
    </message>
    <message>
        <source>Set up as ID %1?</source>
        <translation>设为 ID %1？</translation>
    </message>
    <message>
        <source>Disconnect the servo</source>
        <translation>请拔下舵机</translation>
    </message>
    <message>
        <source>Disconnect the servo: ID %1 is done</source>
        <translation>请拔下舵机：ID %1 已完成</translation>
    </message>
    <message>
        <source>Checking the bus…</source>
        <translation>正在检查总线…</translation>
    </message>
    <message>
        <source>Setting up ID %1…</source>
        <translation>正在设置 ID %1…</translation>
    </message>
    <message>
        <source>%1 for ID %2</source>
        <translation>%1（ID %2）</translation>
    </message>
    <message>
        <source>Unfinished: %1. To finish setting up a servo, connect it and start the same batch again.</source>
        <translation>尚未设置完：%1。接上相应的舵机，再次开始同一批次即可完成设置。</translation>
    </message>
    <message>
        <source>This batch contains an unfinished servo of the same model. Continue only if it is the one that is connected now.</source>
        <translation>此批次中有一个同型号的舵机尚未设置完。确认接上的就是该舵机后再继续。</translation>
    </message>
    <message>
        <source>One servo of this model is still unfinished, and no IDs are left for other servos. If it is the one that is connected now, click &quot;%1&quot;.</source>
        <translation>有一个同型号的舵机尚未设置完，且已没有 ID 可分配给其他舵机。如果接上的就是该舵机，请点击“%1”。</translation>
    </message>
    <message>
        <source>One servo of this model is still unfinished; its assigned ID is %1. If it is the one that is connected now, click &quot;%2&quot;; otherwise, the connected servo will be set up as a new one.</source>
        <translation>有一个同型号的舵机尚未设置完，已为其分配 ID %1。如果接上的就是该舵机，请点击“%2”；否则接上的舵机将作为新舵机设置。</translation>
    </message>
    <message>
        <source>Connect one servo at a time. Each servo receives the template, an ID and the baud rate; it is then checked and recorded in the batch. The servos do not move.</source>
        <translation>每次只接一个舵机。程序会写入模板、ID 和波特率，检查后记入批次。舵机不会转动。</translation>
    </message>
    <message>
        <source>The servos in the list have changed. Searching the bus again.</source>
        <translation>列表中的舵机已变化，正在重新搜索总线。</translation>
    </message>
    <message>
        <source>Connect all servos to the bus, then search the bus to see them.</source>
        <translation>将全部舵机接到总线上，然后搜索总线，即可看到这些舵机。</translation>
    </message>
    <message>
        <source>Label: %1</source>
        <translation>标签：%1</translation>
    </message>
    <message>
        <source>%1, ID %2 at %3 baud</source>
        <translation>%1，ID %2，波特率 %3</translation>
    </message>
    <message>
        <source>%1, ID %2</source>
        <translation>%1，ID %2</translation>
    </message>
    <message>
        <source>%1 with ID %2, %3 baud</source>
        <translation>%1：ID %2，波特率 %3</translation>
    </message>
    <message>
        <source>unidentified servo</source>
        <translation>未识别的舵机</translation>
    </message>
    <message>
        <source>The servo will get ID %1.</source>
        <translation>该舵机的 ID 将设为 %1。</translation>
    </message>
    <message>
        <source>Setup of this servo was interrupted earlier and is now being finished.</source>
        <translation>该舵机先前的设置中断，现在继续完成。</translation>
    </message>
    <message>
        <source>Set ID %1</source>
        <translation>设为 ID %1</translation>
    </message>
    <message>
        <source>Saves the memory table, then writes the template, ID and baud rate</source>
        <translation>先保存内存表，再写入模板、ID 和波特率</translation>
    </message>
    <message>
        <source>Memory table saved before the first write: %1 in %2</source>
        <translation>首次写入前的内存表已保存：%1，位于 %2</translation>
    </message>
    <message>
        <source>Resume setup</source>
        <translation>继续设置</translation>
    </message>
    <message>
        <source>Confirms that this is the unfinished servo, and sets its assigned ID</source>
        <translation>确认这就是尚未设置完的舵机，并写入原先分配的 ID</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translation>剔除</translation>
    </message>
    <message>
        <source>Writes nothing to this servo and records it in the batch as set aside</source>
        <translation>不写入此舵机，在批次中记为剔除</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>接上</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>识别</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Unplug</source>
        <translation>拔下</translation>
    </message>
</context>
<context>
    <name>ui::CompareDialog</name>
    <message>
        <source>Save as web page…</source>
        <translation>保存为网页…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>test %1</source>
        <translation>测试 %1</translation>
    </message>
    <message>
        <source>ID %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>firmware %1</source>
        <translation>固件 %1</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Save the comparison</source>
        <translation>保存对比</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>Saves the comparison as a bilingual web page</source>
        <translation>将对比保存为双语网页</translation>
    </message>
    <message>
        <source>Closes this comparison</source>
        <translation>关闭此对比</translation>
    </message>
    <message>
        <source>Differences between the two tests</source>
        <translation>两次测试之间的差异</translation>
    </message>
    <message>
        <source>Compares the metrics of both servos; the difference is B minus A</source>
        <translation>对比两个舵机的指标；差值为 B 减 A</translation>
    </message>
    <message>
        <source>Settings that differed at the start of the tests</source>
        <translation>测试开始时两个舵机取值不同的参数</translation>
    </message>
</context>
<context>
    <name>ui::CompareModel</name>
    <message>
        <source>no such register</source>
        <translation>没有此参数</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>not written</source>
        <translation>不写入</translation>
    </message>
</context>
<context>
    <name>ui::CompareTables</name>
    <message>
        <source>ID %1 now</source>
        <translation>ID %1 当前</translation>
    </message>
    <message>
        <source>Factory default</source>
        <translation>出厂默认值</translation>
    </message>
    <message>
        <source>Factory default of this model, where known</source>
        <translation>此型号已知的出厂默认值</translation>
    </message>
    <message>
        <source>ID %1 · not read yet</source>
        <translation>ID %1 · 尚未读取</translation>
    </message>
    <message>
        <source>ID %1 · no reply · read %2</source>
        <translation>ID %1 · 无应答 · %2读取</translation>
    </message>
    <message>
        <source>ID %1 · read %2</source>
        <translation>ID %1 · %2读取</translation>
    </message>
</context>
<context>
    <name>ui::ConnectBar</name>
    <message>
        <source>not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>%1/s · %2 err</source>
        <translation>%1 次/秒 · 错误 %2</translation>
    </message>
    <message>
        <source>Baud: auto</source>
        <translation>波特率：自动</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>Protocol: auto</source>
        <translation>协议：自动</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>协议</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>disconnected</source>
        <translation>已断开</translation>
    </message>
    <message>
        <source>opening the port…</source>
        <translation>正在打开端口…</translation>
    </message>
    <message>
        <source>closing the port…</source>
        <translation>正在关闭端口…</translation>
    </message>
    <message>
        <source>adapter disconnected, waiting up to 5 s</source>
        <translation>适配器已断开，等待恢复（最多 5 秒）</translation>
    </message>
    <message>
        <source>waiting…</source>
        <translation>等待恢复…</translation>
    </message>
    <message>
        <source>The adapter was unplugged or lost power. A running test will continue when the adapter is back, but torque will not be turned back on for servos that rebooted in the meantime.</source>
        <translation>适配器已拔出或断电。适配器恢复后，正在运行的测试将继续，但不会为其间重启过的舵机重新打开扭矩。</translation>
    </message>
    <message>
        <source>%1 reads/s · %2 error · bus load %3 %</source>
        <translation>读取 %1 次/秒 · 错误 %2 · 总线占用 %3%</translation>
    </message>
    <message>
        <source>%1 reads/s · %2 errors · bus load %3 %</source>
        <translation>读取 %1 次/秒 · 错误 %2 · 总线占用 %3%</translation>
    </message>
    <message>
        <source>Port: %1 at %2 baud
Sent: %3, replies: %4
Lost: %5, damaged: %6, unexpected: %7, late: %8
Retries: %9</source>
        <translation>端口：%1，波特率 %2
已发送：%3，已应答：%4
丢失：%5，损坏：%6，非预期：%7，迟到：%8
重试：%9</translation>
    </message>
    <message>
        <source>Round trip: median %1 ms, 99th percentile %2 ms</source>
        <translation>往返时间：中位数 %1 毫秒，第 99 百分位 %2 毫秒</translation>
    </message>
    <message>
        <source>Baud rate of the port (auto: the factory baud rate of servos that use the selected protocol)</source>
        <translation>端口的波特率（自动：使用所选协议的舵机的出厂波特率）</translation>
    </message>
    <message>
        <source>Protocol of the servos (auto: tries all protocols that are possible at the selected baud rate)</source>
        <translation>舵机的通信协议（自动：尝试所选波特率下可能使用的全部协议）</translation>
    </message>
    <message>
        <source> (changed)</source>
        <translation>（已更改）</translation>
    </message>
    <message>
        <source>More port settings</source>
        <translation>更多端口设置</translation>
    </message>
    <message>
        <source>Parity, timeout, Modbus frame gap, retries</source>
        <translation>校验位、超时、Modbus 帧间隔、重试次数</translation>
    </message>
    <message>
        <source>These servos are simulated on this computer</source>
        <translation>这些舵机由本机模拟</translation>
    </message>
</context>
<context>
    <name>ui::ControlField</name>
    <message>
        <source>invalid</source>
        <translation>无效</translation>
    </message>
</context>
<context>
    <name>ui::ControlFields</name>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Time (ms)</source>
        <translation>时间 (ms)</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>电流限制</translation>
    </message>
    <message>
        <source>Current 0 = no torque</source>
        <translation>电流为 0 时无扭矩</translation>
    </message>
</context>
<context>
    <name>ui::ControlGoal</name>
    <message>
        <source>Goal</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Step size</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>PWM</source>
        <translation>PWM</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>− %1    ·    + %2</source>
        <translation>− %1    ·    + %2</translation>
    </message>
    <message>
        <source>■ Stop</source>
        <translation>■ 停止</translation>
    </message>
    <message>
        <source>Stop turning</source>
        <translation>停止转动</translation>
    </message>
    <message>
        <source>Steps since connecting: %1. Remaining: %2 %3, %4 %5 (±7.5 turns in total)</source>
        <translation>连接后累计步数：%1。剩余：%2 %3，%4 %5（总共 ±7.5 圈）</translation>
    </message>
    <message>
        <source>Drag, or use the arrow keys, Page Up/Down, Home and End; click once to enable the mouse wheel (Ctrl: fine, Shift: coarse)</source>
        <translation>拖动，或用方向键、Page Up/Down、Home 和 End；点击一次后可用滚轮（Ctrl：微调，Shift：粗调）</translation>
    </message>
    <message>
        <source>Moves by the step size in this direction, starting where the last step ended</source>
        <translation>从上一步的终点起，朝此方向移动一个步长</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>重复</translation>
    </message>
    <message>
        <source>Repeats the last step</source>
        <translation>重复上一步</translation>
    </message>
    <message>
        <source>Stops the motion of this servo; torque stays on</source>
        <translation>停止此舵机的运动；扭矩保持打开</translation>
    </message>
</context>
<context>
    <name>ui::ControlHeader</name>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Motion — ID %1</source>
        <translation>运动 — ID %1</translation>
    </message>
    <message>
        <source>+ %1 more</source>
        <translation>及另外 %1 个</translation>
    </message>
    <message>
        <source>Stopped, but torque is on. Press Esc to turn it off.</source>
        <translation>已急停，但扭矩仍处于打开状态。按 Esc 卸力。</translation>
    </message>
    <message>
        <source>Stopped. Turn torque on to continue.</source>
        <translation>已急停。打开扭矩后才能继续操作。</translation>
    </message>
</context>
<context>
    <name>ui::ControlLimit</name>
    <message>
        <source>Torque limit (until power-off)</source>
        <translation>扭矩限制（断电前有效）</translation>
    </message>
    <message>
        <source>Torque limit</source>
        <translation>扭矩限制</translation>
    </message>
    <message>
        <source>≈ %1 kg·cm</source>
        <translation>≈ %1 kg·cm</translation>
    </message>
    <message>
        <source>Stall torque of this model</source>
        <translation>此型号的堵转扭矩</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>未输入</translation>
    </message>
    <message>
        <source>Percentage of the stall torque (Enter sends the value; Esc turns torque off on the whole bus and shows the present value again)</source>
        <translation>堵转扭矩的百分比（按回车发送；按 Esc 则整条总线卸力，并重新显示当前值）</translation>
    </message>
    <message>
        <source>Maximum output; sent when the slider is released</source>
        <translation>最大输出；松开滑块时发送</translation>
    </message>
    <message>
        <source>Enter the data sheet value for your supply voltage; the value is stored for this model, not written to the servo</source>
        <translation>请输入规格书中对应供电电压的数值；该值按型号保存，不写入舵机</translation>
    </message>
    <message>
        <source>For gripping, set the percentage of the stall torque that the part can withstand (for example, 10 % of 10 kg·cm is 1 kg·cm). A lower limit also makes the servo slower. Use this method only for parts that all have the same mass.</source>
        <translation>用于夹持时，按工件能承受的力设置堵转扭矩的百分比（例如 10 kg·cm 的 10% 为 1 kg·cm）。限制设得越低，舵机也越慢。此方法仅适合重量相同的工件。</translation>
    </message>
    <message>
        <source>Torque limit details</source>
        <translation>扭矩限制的详细设置</translation>
    </message>
    <message>
        <source>Shows the slider and explains how to set a gripping force</source>
        <translation>显示滑块以及如何设定夹持力</translation>
    </message>
</context>
<context>
    <name>ui::ControlMode</name>
    <message>
        <source>Operating mode</source>
        <translation>运行模式</translation>
    </message>
    <message>
        <source>%1 (click to preview what changes when you switch to this mode)</source>
        <translation>%1（点击可预览切换到此模式后的变化）</translation>
    </message>
</context>
<context>
    <name>ui::ControlPanel</name>
    <message>
        <source>Switch ID %1 to &quot;%2&quot;?</source>
        <translation>将 ID %1 切换到“%2”？</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>切换</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>控制</translation>
    </message>
</context>
<context>
    <name>ui::ControlSend</name>
    <message>
        <source>Execute (%1)</source>
        <translation>异步执行 (%1)</translation>
    </message>
    <message>
        <source>Execute</source>
        <translation>异步执行</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>普通写</translation>
    </message>
    <message>
        <source>Writes to one servo after another; each write is acknowledged</source>
        <translation>逐个舵机写入，每次写入都有应答</translation>
    </message>
    <message>
        <source>Sync</source>
        <translation>同步写</translation>
    </message>
    <message>
        <source>Sends one packet to all selected servos; they start together</source>
        <translation>向所有选中的舵机发送同一个数据包，使其同时启动</translation>
    </message>
    <message>
        <source>Async</source>
        <translation>异步写</translation>
    </message>
    <message>
        <source>Stores the goal in the servo until you click Execute</source>
        <translation>将目标存入舵机，点击“异步执行”后才开始运动</translation>
    </message>
    <message>
        <source>Executes all goals waiting in the servos</source>
        <translation>执行各舵机中所有待执行的目标</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Sends the goal and the changed fields</source>
        <translation>发送目标和已修改的参数</translation>
    </message>
</context>
<context>
    <name>ui::ControlTorque</name>
    <message>
        <source>Damping</source>
        <translation>阻尼</translation>
    </message>
    <message>
        <source>Torque: not read</source>
        <translation>扭矩：未读取</translation>
    </message>
    <message>
        <source>● Torque on</source>
        <translation>● 扭矩已打开</translation>
    </message>
    <message>
        <source>◐ Damping</source>
        <translation>◐ 阻尼</translation>
    </message>
    <message>
        <source>○ Torque off</source>
        <translation>○ 已卸力</translation>
    </message>
    <message>
        <source>Does not hold the position, but brakes the shaft when it is turned</source>
        <translation>不保持位置，但转动输出轴时有阻力</translation>
    </message>
    <message>
        <source>More torque options</source>
        <translation>更多扭矩选项</translation>
    </message>
    <message>
        <source>Damping and midpoint</source>
        <translation>阻尼、设为中位</translation>
    </message>
    <message>
        <source>When torque is on, the servo holds its present position; when it is off, the shaft turns freely</source>
        <translation>打开扭矩时，舵机保持当前位置；卸力时，输出轴可自由转动</translation>
    </message>
</context>
<context>
    <name>ui::CursorTable</name>
    <message>
        <source>Copy readings</source>
        <translation>复制读数</translation>
    </message>
    <message>
        <source>Copies the whole table for pasting into a spreadsheet</source>
        <translation>复制整个表格，可粘贴到电子表格</translation>
    </message>
    <message>
        <source>Readings at the cursors</source>
        <translation>游标读数</translation>
    </message>
    <message>
        <source>Values at cursors A and B, and statistics of the samples between them</source>
        <translation>游标 A、B 处的数值，以及两者之间各采样的统计</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>At A</source>
        <translation>A 处</translation>
    </message>
    <message>
        <source>At B</source>
        <translation>B 处</translation>
    </message>
    <message>
        <source>Δ</source>
        <translation>Δ</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>斜率</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>σ</source>
        <translation>σ</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>A %1 · B %2 · Δt %3</source>
        <translation>A %1 · B %2 · Δt %3</translation>
    </message>
    <message>
        <source>Slope of the least-squares line through the samples, per second</source>
        <translation>采样点的最小二乘拟合直线的斜率（每秒）</translation>
    </message>
    <message>
        <source>Standard deviation of the samples</source>
        <translation>采样值的标准差</translation>
    </message>
    <message>
        <source>Number of samples between A and B; ≈ means that only the extremes of some of them are stored</source>
        <translation>A、B 之间的采样数；“≈”表示其中一部分只保留了极值</translation>
    </message>
    <message>
        <source>No cursors. Press C in the chart to show them, then drag A and B.</source>
        <translation>未显示游标。在曲线图中按 C 显示游标，然后拖动 A 和 B。</translation>
    </message>
</context>
<context>
    <name>ui::DiagnosisDialog</name>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Run again</source>
        <translation>重新诊断</translation>
    </message>
    <message>
        <source>Ends the diagnosis</source>
        <translation>结束诊断</translation>
    </message>
    <message>
        <source>Runs all checks again; writes nothing</source>
        <translation>重新执行所有检查；不写入任何内容</translation>
    </message>
    <message>
        <source>Looking for the cause…</source>
        <translation>正在查找原因…</translation>
    </message>
    <message>
        <source>The diagnosis was stopped.</source>
        <translation>诊断已停止。</translation>
    </message>
    <message>
        <source>Also possible: %1</source>
        <translation>也可能是：%1</translation>
    </message>
    <message>
        <source>Set up servos one at a time</source>
        <translation>逐个接上并设置舵机</translation>
    </message>
    <message>
        <source>Shows the Commissioning page</source>
        <translation>显示“批量设置”页</translation>
    </message>
    <message>
        <source>Opens the port again at this baud rate</source>
        <translation>以此波特率重新打开端口</translation>
    </message>
    <message>
        <source>Connect and detect the protocol</source>
        <translation>连接并自动识别协议</translation>
    </message>
    <message>
        <source>Opens the port again and detects the protocol</source>
        <translation>重新打开端口并自动识别协议</translation>
    </message>
    <message>
        <source>Why is a servo not replying?</source>
        <translation>舵机为何不应答？</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>What was found; nothing is written to a servo</source>
        <translation>检查结果；不会向舵机写入任何内容</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Progress of the diagnosis</source>
        <translation>诊断的进度</translation>
    </message>
    <message>
        <source>Copy report</source>
        <translation>复制报告</translation>
    </message>
    <message>
        <source>Copies the checks and the cause as text</source>
        <translation>以文本形式复制检查结果和原因</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Closes this window</source>
        <translation>关闭此窗口</translation>
    </message>
    <message>
        <source>Searching at %1 baud…</source>
        <translation>正在以波特率 %1 搜索…</translation>
    </message>
    <message>
        <source>Connect at %1 baud</source>
        <translation>以波特率 %1 连接</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Rescue firmware…</source>
        <translation>救援固件…</translation>
    </message>
    <message>
        <source>Writes the vendor&apos;s firmware file to this servo</source>
        <translation>把厂家的固件文件写入这个舵机</translation>
    </message>
</context>
<context>
    <name>ui::DryRunDialog</name>
    <message>
        <source>What would be written</source>
        <translation>将要写入的内容</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Old</source>
        <translation>原值</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新值</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>✗ %1: %2</source>
        <translation>✗ %1：%2</translation>
    </message>
    <message>
        <source>%1, not selected: %2</source>
        <translation>%1（未勾选）：%2</translation>
    </message>
    <message>
        <source>ID %1: nothing to write. All selected rows already match.</source>
        <translation>ID %1：无需写入。已勾选的行都已与舵机中的值一致。</translation>
    </message>
    <message>
        <source>ID %1: the rows will be written in this order, and each will be read back. Nothing has been written yet.</source>
        <translation>ID %1：将按此顺序写入，每一行都会回读；目前尚未写入任何内容。</translation>
    </message>
    <message>
        <source>Copies the steps as text</source>
        <translation>把步骤复制为文本</translation>
    </message>
    <message>
        <source>Closes the dialog; nothing is written</source>
        <translation>关闭对话框，不写入任何内容</translation>
    </message>
    <message>
        <source>The snapshot is from a different model: %1.</source>
        <translation>此快照来自其他型号：%1。</translation>
    </message>
</context>
<context>
    <name>ui::EnumEditor</name>
    <message>
        <source>not documented</source>
        <translation>资料中没有说明</translation>
    </message>
    <message>
        <source>Select a value. %1</source>
        <translation>选择一个值。%1</translation>
    </message>
</context>
<context>
    <name>ui::ErrorHistogram</name>
    <message>
        <source>Moves: %1. Error: %2 to %3 %4, mean %5 %4.</source>
        <translation>行程数：%1。误差：%2 至 %3 %4，平均 %5 %4。</translation>
    </message>
    <message>
        <source>Beyond the warning limit of %1 %2: %3.</source>
        <translation>超出警告限值 %1 %2：%3。</translation>
    </message>
    <message>
        <source>Beyond the limit of %1 %2: %3.</source>
        <translation>超出限值 %1 %2：%3。</translation>
    </message>
    <message>
        <source>%1 to %2 %3: %4 of %5 moves (%6 %)</source>
        <translation>%1 至 %2 %3：%5 个行程中有 %4 个（%6%）</translation>
    </message>
    <message>
        <source>No steady-state error has been measured yet.</source>
        <translation>尚未测得静差。</translation>
    </message>
    <message>
        <source>Steady-state error</source>
        <translation>静差</translation>
    </message>
</context>
<context>
    <name>ui::ExportControl</name>
    <message>
        <source>Export view</source>
        <translation>导出视图</translation>
    </message>
    <message>
        <source>Image (*.png)</source>
        <translation>图片 (*.png)</translation>
    </message>
    <message>
        <source>Vector graphic (*.svg)</source>
        <translation>矢量图 (*.svg)</translation>
    </message>
    <message>
        <source>Trend %1</source>
        <translation>曲线图 %1</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
    <message>
        <source>The view could not be exported: %1</source>
        <translation>无法导出视图：%1</translation>
    </message>
    <message>
        <source>Check the folder and the free disk space.</source>
        <translation>请检查文件夹和磁盘剩余空间。</translation>
    </message>
    <message>
        <source>Table for spreadsheets (*.csv)</source>
        <translation>电子表格 (*.csv)</translation>
    </message>
</context>
<context>
    <name>ui::FindServosDialog</name>
    <message>
        <source>Possibly several servos with one ID.</source>
        <translation>可能有多个舵机使用同一个 ID。</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>正在搜索…</translation>
    </message>
    <message>
        <source>No servo replied.</source>
        <translation>没有舵机应答。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>重新搜索</translation>
    </message>
    <message>
        <source>Ends the search; what was found stays in the list</source>
        <translation>结束搜索；已找到的结果保留在列表中</translation>
    </message>
    <message>
        <source>Searches all ports again; writes nothing</source>
        <translation>重新搜索所有端口；不写入任何内容</translation>
    </message>
    <message>
        <source>Searching at %1 baud…</source>
        <translation>正在以波特率 %1 搜索…</translation>
    </message>
    <message>
        <source>Find servos on all ports</source>
        <translation>在所有端口上查找舵机</translation>
    </message>
    <message>
        <source>This computer has no serial port. Plug in the adapter, then search again.</source>
        <translation>本机没有串口。请插入适配器，然后重新搜索。</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Ports</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>What replied on each port</source>
        <translation>每个端口上的应答结果</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Progress of the search on this port</source>
        <translation>此端口的搜索进度</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Opens the selected port at the rate of its servos</source>
        <translation>以舵机所用的波特率打开选中的端口</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Closes this window and ends the search</source>
        <translation>关闭此窗口并结束搜索</translation>
    </message>
    <message>
        <source>ID %1 (%2)</source>
        <translation>ID %1（%2）</translation>
    </message>
    <message numerus="yes">
        <source>%n servo(s) · %1 · %2 baud</source>
        <translation>
            <numerusform>%n 个舵机 · %1 · 波特率 %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Search not finished</source>
        <translation>搜索未完成</translation>
    </message>
    <message>
        <source>Searches each serial port at every baud rate until a servo replies. Nothing is written. Devices that are not servo adapters receive the queries too: unplug them first.</source>
        <translation>以各种波特率依次搜索每个串口，直到有舵机应答。不写入任何内容。非舵机适配器的设备也会收到这些查询：请先拔下它们。</translation>
    </message>
</context>
<context>
    <name>ui::FirmwarePage</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Differs from the others of its model</source>
        <translation>与同型号的其他舵机不同</translation>
    </message>
    <message>
        <source>The firmware versions differ. LeRobot refuses a bus whose servos do not all have the same version.</source>
        <translation>固件版本不一致。总线上的舵机固件版本不全相同时，LeRobot 拒绝连接。</translation>
    </message>
    <message numerus="yes">
        <source>All %n servo(s) run firmware %1.</source>
        <translation>
            <numerusform>全部 %n 个舵机的固件均为 %1。</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the list</source>
        <translation>保存列表</translation>
    </message>
    <message>
        <source>Table for spreadsheets (*.csv)</source>
        <translation>电子表格 (*.csv)</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>Model number</source>
        <translation>型号编号</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>Newer version known</source>
        <translation>已知的较新版本</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>No servos in the list yet. Search the bus.</source>
        <translation>列表中还没有舵机，请搜索总线。</translation>
    </message>
    <message>
        <source>Firmware versions</source>
        <translation>固件版本</translation>
    </message>
    <message>
        <source>One row per servo of the list</source>
        <translation>列表中的每个舵机一行</translation>
    </message>
    <message>
        <source>Save list…</source>
        <translation>保存列表…</translation>
    </message>
    <message>
        <source>Saves the versions as a table for spreadsheets</source>
        <translation>将版本保存为电子表格</translation>
    </message>
    <message>
        <source>Newer versions are listed in the vendor&apos;s firmware catalog; they may not be the latest.</source>
        <translation>较新的版本取自厂家的固件目录，不一定是最新的。</translation>
    </message>
</context>
<context>
    <name>ui::HelpWindow</name>
    <message>
        <source>ServoDesk Help</source>
        <translation>ServoDesk 帮助</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
</context>
<context>
    <name>ui::HistoryDetails</name>
    <message>
        <source>Select an entry to see its details.</source>
        <translation>选择一条记录以查看详情。</translation>
    </message>
</context>
<context>
    <name>ui::HistoryFilterBar</name>
    <message>
        <source>All registers</source>
        <translation>所有参数</translation>
    </message>
    <message>
        <source>This computer</source>
        <translation>本机</translation>
    </message>
    <message>
        <source>Server: all benches</source>
        <translation>服务器：所有工位</translation>
    </message>
    <message>
        <source>Server: %1</source>
        <translation>服务器：%1</translation>
    </message>
    <message>
        <source>All servos</source>
        <translation>所有舵机</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>The history of this computer, or the copies on the server</source>
        <translation>本机的历史记录，或服务器上的副本</translation>
    </message>
    <message>
        <source>List</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>Kind of entries to list</source>
        <translation>要列出的记录类型</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>Shows only entries for this servo</source>
        <translation>只看此舵机的记录</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Shows only writes to this register</source>
        <translation>只看写入此参数的记录</translation>
    </message>
    <message>
        <source>Any time</source>
        <translation>全部时间</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>今天</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>最近 7 天</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>最近 30 天</translation>
    </message>
    <message>
        <source>Last 365 days</source>
        <translation>最近 365 天</translation>
    </message>
    <message>
        <source>Custom range…</source>
        <translation>自定义时间段…</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Shows only entries from this period</source>
        <translation>只看这段时间的记录</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>Start date</source>
        <translation>开始日期</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>到</translation>
    </message>
    <message>
        <source>End date</source>
        <translation>结束日期</translation>
    </message>
    <message>
        <source>Problems only</source>
        <translation>只看问题</translation>
    </message>
    <message>
        <source>Shows only failed writes and alarms that are still active</source>
        <translation>只看失败的写入和尚未解除的报警</translation>
    </message>
</context>
<context>
    <name>ui::HistoryPage</name>
    <message>
        <source>Earlier tests…</source>
        <translation>以往测试…</translation>
    </message>
    <message>
        <source>Open snapshot</source>
        <translation>打开快照</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史记录</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Server…</source>
        <translation>服务器…</translation>
    </message>
    <message>
        <source>from the server</source>
        <translation>来自服务器</translation>
    </message>
    <message>
        <source>before %1</source>
        <translation>%1 之前</translation>
    </message>
    <message>
        <source>Export the history</source>
        <translation>导出历史记录</translation>
    </message>
    <message>
        <source>Table for spreadsheets (*.csv)</source>
        <translation>电子表格 (*.csv)</translation>
    </message>
    <message>
        <source>Data (*.json)</source>
        <translation>数据 (*.json)</translation>
    </message>
    <message>
        <source>The ID was changed on %1.</source>
        <translation>ID 于 %1 更改。</translation>
    </message>
    <message>
        <source>Memory table before write</source>
        <translation>写入前的内存表</translation>
    </message>
    <message>
        <source>Opens the servo&apos;s memory table as it was just before this write; you can compare and restore it</source>
        <translation>打开此次写入之前舵机的内存表，可对比和恢复</translation>
    </message>
    <message>
        <source>Shows reports and comparisons of saved tests</source>
        <translation>显示以往测试的报告与对比</translation>
    </message>
    <message>
        <source>Opens the snapshot so that you can compare and restore it</source>
        <translation>打开快照，可对比和恢复</translation>
    </message>
    <message>
        <source>Loading…</source>
        <translation>正在载入…</translation>
    </message>
    <message>
        <source>No entries</source>
        <translation>没有记录</translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s)</source>
        <translation>
            <numerusform>%Ln 行</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln or more rows</source>
        <translation>
            <numerusform>%Ln 行以上</numerusform>
        </translation>
    </message>
    <message>
        <source>Some register values from that time are unknown.</source>
        <translation>当时有些参数的值未知。</translation>
    </message>
    <message>
        <source>These registers were changed by unrecorded operations: %1.</source>
        <translation>有未记录的操作更改过以下参数：%1。</translation>
    </message>
    <message>
        <source>Restoring the memory table leaves these registers unchanged.</source>
        <translation>恢复内存表时不改动这些参数。</translation>
    </message>
    <message>
        <source>The servo had ID %1 at that time.</source>
        <translation>当时舵机的 ID 是 %1。</translation>
    </message>
    <message>
        <source>Writes made under ID %1 are in the history of the servo with that ID, not in this memory table.</source>
        <translation>使用 ID %1 期间的写入，记在该 ID 对应舵机的历史记录中，不在此内存表中。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s) saved: %1</source>
        <translation>
            <numerusform>已保存 %Ln 行：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Saves the filtered list as CSV or JSON</source>
        <translation>把筛选后的列表保存为 CSV 或 JSON</translation>
    </message>
    <message>
        <source>Sends copies of the history to a PostgreSQL server and shows the history of all benches</source>
        <translation>把历史记录副本发送到 PostgreSQL 服务器，并查看所有工位的记录</translation>
    </message>
    <message>
        <source>Servos have no serial number. They are identified by model, firmware, ID and the label you assign; two identical servos without a label cannot be distinguished.</source>
        <translation>舵机没有序列号。只能凭型号、固件、ID 和您添加的标签区分：两个相同且没有标签的舵机无法区分。</translation>
    </message>
    <message>
        <source>Label…</source>
        <translation>标签…</translation>
    </message>
    <message>
        <source>Labels the servo or the snapshot</source>
        <translation>给舵机或快照加标签</translation>
    </message>
    <message>
        <source>Open step response</source>
        <translation>打开阶跃响应</translation>
    </message>
    <message>
        <source>Shows this run on the Step response page, where the next run is compared with it</source>
        <translation>在“阶跃响应”页显示此次运行，下一次运行将与它对比</translation>
    </message>
    <message>
        <source>Select a write.</source>
        <translation>请选择一条写入记录。</translation>
    </message>
    <message>
        <source>Undo this write</source>
        <translation>撤销此次写入</translation>
    </message>
    <message>
        <source>Writes the old value back to the servo after you confirm</source>
        <translation>经确认后将原值写回舵机</translation>
    </message>
    <message>
        <source>Newest first</source>
        <translation>最新的在前</translation>
    </message>
    <message>
        <source>All entries for this servo</source>
        <translation>此舵机的全部记录</translation>
    </message>
    <message>
        <source>Lists only entries for the servo in this row</source>
        <translation>仅列出该行舵机的记录</translation>
    </message>
    <message>
        <source>No entries under “%1” match the filters above.</source>
        <translation>“%1”中没有符合上方筛选条件的记录。</translation>
    </message>
    <message>
        <source>No entries under “%1” yet. Select another kind of entry above: writes, snapshots, tests, alarms, recordings or servos.</source>
        <translation>“%1”中还没有记录。可在上方选择其他类别：写入、快照、测试、报警、录制或舵机。</translation>
    </message>
</context>
<context>
    <name>ui::HistorySendLabel</name>
    <message>
        <source>⚠ %1: new data will be sent later.</source>
        <translation>⚠ %1：新数据将稍后发送。</translation>
    </message>
    <message>
        <source>History server</source>
        <translation>历史记录服务器</translation>
    </message>
    <message numerus="yes">
        <source>Sending %Ln row(s) to %1</source>
        <translation>
            <numerusform>正在向 %1 发送 %Ln 行</numerusform>
        </translation>
    </message>
    <message>
        <source>Sending to %1…</source>
        <translation>正在向 %1 发送…</translation>
    </message>
    <message>
        <source>✔ %1 is up to date</source>
        <translation>✔ %1：已全部发送</translation>
    </message>
</context>
<context>
    <name>ui::HistoryServerDialog</name>
    <message>
        <source>History server</source>
        <translation>历史记录服务器</translation>
    </message>
    <message>
        <source>&amp;Server</source>
        <translation>服务器(&amp;S)</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>服务器</translation>
    </message>
    <message>
        <source>&amp;Name of this bench</source>
        <translation>本工位名称(&amp;N)</translation>
    </message>
    <message>
        <source>Name of this bench</source>
        <translation>本工位名称</translation>
    </message>
    <message>
        <source>The server is set by the environment variable SERVODESK_HISTORY_SERVER.</source>
        <translation>服务器由环境变量 SERVODESK_HISTORY_SERVER 指定。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Store the password in ~/.pgpass, not in the connection string. A server on another computer must use TLS with a valid certificate; to change that, add ?sslmode=… to the connection string.</source>
        <translation>密码请存放在 ~/.pgpass 中，不要写在连接字符串里。其他计算机上的服务器必须使用带有效证书的 TLS；如需更改，请在连接字符串后加 ?sslmode=…。</translation>
    </message>
    <message>
        <source>PostgreSQL connection string; leave empty to keep the history on this computer only</source>
        <translation>PostgreSQL 连接字符串；留空则历史记录只保存在本机</translation>
    </message>
    <message>
        <source>Name under which other benches find this bench&apos;s history on the server</source>
        <translation>其他工位在服务器上凭此名称找到本工位的历史记录</translation>
    </message>
    <message>
        <source>Saves the settings and starts sending</source>
        <translation>保存设置并开始发送</translation>
    </message>
    <message>
        <source>Discards the changes</source>
        <translation>放弃更改</translation>
    </message>
    <message>
        <source>Writes, snapshots, labels and tests from this bench are copied to a PostgreSQL server, where all benches can be viewed together. This computer keeps its own complete history; an unreachable server never blocks a write.</source>
        <translation>本工位的写入、快照、标签和测试会复制到 PostgreSQL 服务器，可在那里集中查看所有工位的记录。本机仍保存完整的历史记录；即使服务器连接不上，也绝不影响写入。</translation>
    </message>
</context>
<context>
    <name>ui::LerobotCard</name>
    <message>
        <source>LeRobot</source>
        <translation>LeRobot</translation>
    </message>
    <message>
        <source>Prepare servos…</source>
        <translation>准备舵机…</translation>
    </message>
    <message>
        <source>Writes the settings that LeRobot writes at each start: mode, gains, reply delay, gripper limits</source>
        <translation>写入 LeRobot 每次启动时写入的参数：模式、增益、返回延时、夹爪限制</translation>
    </message>
    <message>
        <source>Compare with file…</source>
        <translation>与文件对比…</translation>
    </message>
    <message>
        <source>Selects a calibration file and compares it with the servos</source>
        <translation>选择校准文件并与舵机对比</translation>
    </message>
    <message>
        <source>Write file to servos…</source>
        <translation>把文件写入舵机…</translation>
    </message>
    <message>
        <source>Writes offsets and limits of the file to the servos</source>
        <translation>把文件中的位置校正和角度限制写入舵机</translation>
    </message>
    <message>
        <source>Save servos to file…</source>
        <translation>把舵机的值保存到文件…</translation>
    </message>
    <message>
        <source>Saves what the servos hold as a calibration file</source>
        <translation>把舵机中的值保存为校准文件</translation>
    </message>
    <message>
        <source>LeRobot accepts its file only if it equals what the servos hold. Select the file to compare it.</source>
        <translation>只有文件与舵机中的值相同时，LeRobot 才接受。请选择要对比的文件。</translation>
    </message>
    <message>
        <source>%1: cannot be compared before all servos have been read.</source>
        <translation>%1：读取所有舵机后才能对比。</translation>
    </message>
    <message>
        <source>✓ %1 equals the servos.</source>
        <translation>✓ %1 与舵机中的值一致。</translation>
    </message>
    <message>
        <source>! %1 differs from the servos: LeRobot would ask for a new calibration.</source>
        <translation>! %1 与舵机中的值不一致：LeRobot 会要求重新校准。</translation>
    </message>
    <message>
        <source> The Firmware page shows and updates them.</source>
        <translation>可在“固件”页查看和更新。</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>位置校正</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>%1: not in the file with ID %2</source>
        <translation>%1：文件中没有 ID 为 %2 的此关节</translation>
    </message>
    <message>
        <source>%1: not a joint of this arm</source>
        <translation>%1：不是此机械臂的关节</translation>
    </message>
    <message>
        <source>%1: %2 is %3 in the file, %4 in the servo</source>
        <translation>%1：%2 在文件中为 %3，在舵机中为 %4</translation>
    </message>
    <message>
        <source>Select the calibration file</source>
        <translation>选择校准文件</translation>
    </message>
    <message>
        <source>Calibration files (*.json)</source>
        <translation>校准文件 (*.json)</translation>
    </message>
    <message>
        <source>Write %1 to the servos?</source>
        <translation>把 %1 写入舵机？</translation>
    </message>
    <message>
        <source>Torque is turned off: hold the arm. Offsets shift the zero positions.</source>
        <translation>将会卸力：请扶住机械臂。位置校正会移动零位。</translation>
    </message>
    <message>
        <source>Write to servos</source>
        <translation>写入舵机</translation>
    </message>
    <message>
        <source>Write LeRobot&apos;s settings to the servos?</source>
        <translation>将 LeRobot 的参数写入舵机？</translation>
    </message>
    <message>
        <source>Torque is turned off: hold the arm.</source>
        <translation>将会卸力：请扶住机械臂。</translation>
    </message>
    <message>
        <source>Save the calibration</source>
        <translation>保存校准</translation>
    </message>
    <message>
        <source>! %1: LeRobot expects other models and refuses the bus. Fit those models, or enter the present ones both in the arm and in LeRobot&apos;s code.</source>
        <translation>! %1：LeRobot 要求其他型号，会拒绝连接。请换成要求的型号，或在机械臂定义和 LeRobot 代码中都填现有型号。</translation>
    </message>
</context>
<context>
    <name>ui::LimitsDialog</name>
    <message>
        <source>Enter a tolerance greater than 0 steps, or leave the field empty.</source>
        <translation>允差必须是大于 0 的步数，或留空。</translation>
    </message>
    <message>
        <source>Row %1, %2: %3</source>
        <translation>第 %1 行，%2：%3</translation>
    </message>
    <message>
        <source>Limits (*.json)</source>
        <translation>限值 (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Sweep test limits</source>
        <translation>扫描测试的限值</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>Tolerance, steps</source>
        <translation>到位允差（步）</translation>
    </message>
    <message>
        <source>any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>Load built-in limits</source>
        <translation>载入内置限值</translation>
    </message>
    <message>
        <source>Loads the limits that come with the program</source>
        <translation>载入程序自带的限值</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>载入…</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Use these limits</source>
        <translation>使用这些限值</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Enter a name for these limits; it appears in the report.</source>
        <translation>请为限值命名：报告中会写明舵机按哪组限值判定。</translation>
    </message>
    <message>
        <source>Add at least one limit; without limits, every servo would pass.</source>
        <translation>请至少添加一条限值；没有限值时，所有舵机都会判为合格。</translation>
    </message>
    <message>
        <source>Uses these limits from now on</source>
        <translation>今后按这些限值判定</translation>
    </message>
    <message>
        <source>Saves these limits to a file</source>
        <translation>将这些限值保存到文件</translation>
    </message>
    <message>
        <source>Load limits</source>
        <translation>从文件载入限值</translation>
    </message>
    <message>
        <source>Save limits</source>
        <translation>保存限值</translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation>已保存到 %1</translation>
    </message>
    <message>
        <source>Appears in the report</source>
        <translation>记入报告</translation>
    </message>
    <message>
        <source>Models or families that these limits apply to, separated by commas; leave empty for any</source>
        <translation>适用的型号或系列，以逗号分隔；留空表示任意</translation>
    </message>
    <message>
        <source>A goal counts as reached within this distance; leave empty to use the family default</source>
        <translation>距目标在此范围内即为到位；留空则用该系列的默认值</translation>
    </message>
    <message>
        <source>family default</source>
        <translation>该系列默认值</translation>
    </message>
    <message>
        <source>One row per limit; type or press F2 to change a value</source>
        <translation>每行一个限值；直接输入或按 F2 修改</translation>
    </message>
    <message>
        <source>Add limit</source>
        <translation>添加限值</translation>
    </message>
    <message>
        <source>Adds a limit for another metric</source>
        <translation>为另一项指标设限值</translation>
    </message>
    <message>
        <source>Remove limit</source>
        <translation>删除限值</translation>
    </message>
    <message>
        <source>Removes the selected limit</source>
        <translation>删除所选指标的限值</translation>
    </message>
    <message>
        <source>Discards the changes</source>
        <translation>放弃更改</translation>
    </message>
</context>
<context>
    <name>ui::LimitsModel</name>
    <message>
        <source>at least</source>
        <translation>至少</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>至多</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number.</source>
        <translation>“%1”不是数字。</translation>
    </message>
    <message>
        <source>Must be</source>
        <translation>要求</translation>
    </message>
    <message>
        <source>Only for sine tests; ignored in other tests</source>
        <translation>仅用于正弦测试；其他测试忽略此项</translation>
    </message>
    <message>
        <source>Only for sine tests (% of the amplitude) and random tests (% of the range); ignored in other tests</source>
        <translation>仅用于正弦测试（占幅值的百分比）和随机目标测试（占行程范围的百分比）；其他测试忽略此项</translation>
    </message>
    <message>
        <source>A limit cannot be negative: errors are judged by their absolute value.</source>
        <translation>限值不能为负：误差按绝对值判定。</translation>
    </message>
    <message>
        <source>Enter a warning limit, a failure limit, or both.</source>
        <translation>请填写警告限值、不合格限值，或两者。</translation>
    </message>
    <message>
        <source>The failure limit would be reached before the warning limit. Change one of them.</source>
        <translation>按此设置，会先判不合格、后警告：请修改其中一个限值。</translation>
    </message>
    <message>
        <source>This metric already has a limit of this kind (at least or at most).</source>
        <translation>该指标已有一条同类限值（至少或至多）。</translation>
    </message>
    <message>
        <source>Limit in the unit of the metric; leave empty for no limit</source>
        <translation>以该指标的单位填写数值；留空表示无此限值</translation>
    </message>
</context>
<context>
    <name>ui::LinkErrorBanner</name>
    <message>
        <source>%1 was unplugged.</source>
        <translation>%1 已拔出。</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>The connection to %1 was lost.</source>
        <translation>与 %1 的连接已断开。</translation>
    </message>
    <message>
        <source>Opens the port again with the settings above</source>
        <translation>按上方设置再次打开端口</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>重新连接</translation>
    </message>
    <message>
        <source>Opens the port again and checks whether the servos in the list reply; writes nothing</source>
        <translation>重新打开端口，检查列表中的舵机是否应答；不写入任何内容</translation>
    </message>
    <message>
        <source>ServoDesk keeps trying to reconnect until you close this message. A write that was in progress is recorded in the journal and will be checked first.</source>
        <translation>ServoDesk 会不断尝试重新连接，关闭此提示即停止尝试。当时正在进行的写入已记在写入日志中，重新连接后会先核对。</translation>
    </message>
    <message>
        <source>ServoDesk reconnects automatically when you plug the adapter in again; close this message to stay disconnected. A write that was in progress is recorded in the journal and will be checked first.</source>
        <translation>重新插上适配器后，ServoDesk 会自动重新连接；关闭此提示则保持断开。当时正在进行的写入已记在写入日志中，重新连接后会先核对。</translation>
    </message>
</context>
<context>
    <name>ui::LinkOptions</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>even</source>
        <translation>偶校验</translation>
    </message>
    <message>
        <source>odd</source>
        <translation>奇校验</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> 毫秒</translation>
    </message>
    <message>
        <source> µs</source>
        <translation> 微秒</translation>
    </message>
    <message>
        <source>Parity</source>
        <translation>校验位</translation>
    </message>
    <message>
        <source>Modbus frame gap</source>
        <translation>Modbus 帧间隔</translation>
    </message>
    <message>
        <source>Retries</source>
        <translation>重试次数</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>超时</translation>
    </message>
    <message>
        <source>Servos are set to no parity at the factory</source>
        <translation>舵机出厂设置为无校验</translation>
    </message>
    <message>
        <source>Pause between Modbus frames (auto: the standard pause for the baud rate)</source>
        <translation>Modbus 帧之间的停顿（自动：该波特率下的标准停顿）</translation>
    </message>
    <message>
        <source>Number of times a lost request is sent again, if it is safe to repeat</source>
        <translation>请求丢失时的重发次数（仅限可重复的请求）</translation>
    </message>
    <message>
        <source>Time to wait for a reply, in addition to the transmission time (auto: adjusted to this adapter; a servo counts as silent after 500 ms)</source>
        <translation>等待应答的时间，不含传输时间（自动：按适配器调整，500 毫秒后才判定舵机无应答）</translation>
    </message>
</context>
<context>
    <name>ui::LockBadge</name>
    <message>
        <source>no EPROM lock</source>
        <translation>无 EPROM 锁</translation>
    </message>
    <message>
        <source>EPROM lock not read</source>
        <translation>尚未读取 EPROM 锁状态</translation>
    </message>
    <message>
        <source>EPROM locked</source>
        <translation>EPROM 已上锁</translation>
    </message>
    <message>
        <source>This family has no EPROM lock. The servo stores every setting immediately.</source>
        <translation>该系列没有 EPROM 锁。舵机会立即保存每项设置。</translation>
    </message>
    <message>
        <source>The EPROM lock has not been read. Choose Read all.</source>
        <translation>尚未读取 EPROM 锁状态。请点击“读取全部”。</translation>
    </message>
    <message>
        <source>The EPROM is locked. ServoDesk unlocks it for a write and locks it again afterwards.</source>
        <translation>EPROM 已上锁。ServoDesk 写入时自动解锁，写完重新上锁。</translation>
    </message>
    <message>
        <source>ServoDesk unlocked the EPROM for a write that has not finished. If no write is in progress, open Port → Interrupted writes.</source>
        <translation>ServoDesk 为写入解锁了 EPROM，但这次写入尚未结束。如果当前没有写入在进行，请打开“端口 → 未写完的更改”。</translation>
    </message>
    <message>
        <source>Another program left the EPROM unlocked, so values written by any program are kept after power-off. Lock the EPROM when you have finished with that program.</source>
        <translation>其他程序没有给 EPROM 上锁，因此任何程序写入的内容断电后都会保留。用完该程序后，请给 EPROM 上锁。</translation>
    </message>
    <message>
        <source>Lock the EPROM</source>
        <translation>EPROM 上锁</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>上锁</translation>
    </message>
    <message>
        <source>EPROM unlocked</source>
        <translation>EPROM 未上锁</translation>
    </message>
    <message>
        <source>EPROM left unlocked</source>
        <translation>EPROM 未重新上锁</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>ServoDesk</source>
        <translation>ServoDesk</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>舵机搜索</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Esc   All torque off</source>
        <translation>Esc   全部卸力</translation>
    </message>
    <message>
        <source>Turn torque off on all servos</source>
        <translation>全部舵机卸力</translation>
    </message>
</context>
<context>
    <name>ui::MemoryOutput</name>
    <message>
        <source>Table for spreadsheets (*.csv)</source>
        <translation>电子表格 (*.csv)</translation>
    </message>
    <message>
        <source>Export the memory table</source>
        <translation>导出内存表</translation>
    </message>
    <message>
        <source>Web page to view or print (*.html)</source>
        <translation>可阅读或打印的网页 (*.html)</translation>
    </message>
</context>
<context>
    <name>ui::MemoryPage</name>
    <message>
        <source>The firmware of this servo is not known.</source>
        <translation>该舵机的固件版本未知。</translation>
    </message>
    <message>
        <source>Memory table</source>
        <translation>内存表</translation>
    </message>
    <message>
        <source>Select a servo on the left to see its memory table. Selecting a servo only reads it and writes nothing.</source>
        <translation>请在左侧选择舵机以查看内存表。选择时只读取，不写入。</translation>
    </message>
    <message>
        <source>No register matches the filter.</source>
        <translation>没有符合筛选条件的参数。</translation>
    </message>
    <message>
        <source>No published register map matches this firmware, so a write could cause damage.</source>
        <translation>没有与此固件相符的公开内存表，写入可能造成损坏。</translation>
    </message>
    <message>
        <source>Only the servo&apos;s identity and its measurements are shown. Add a model file to allow writing.</source>
        <translation>只显示身份信息和测量值。添加型号文件后才能写入。</translation>
    </message>
    <message>
        <source>Press Enter or double-click to edit a value; nothing is written until you press Enter after editing</source>
        <translation>按回车或双击可修改数值；再次按回车之前不会写入</translation>
    </message>
    <message>
        <source>The table was saved to %1.</source>
        <translation>内存表已保存到 %1。</translation>
    </message>
</context>
<context>
    <name>ui::MemoryToolbar</name>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Find a register</source>
        <translation>查找参数</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>已改</translation>
    </message>
    <message>
        <source>≠ default</source>
        <translation>≠ 默认</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>分组</translation>
    </message>
    <message>
        <source>All groups</source>
        <translation>全部分组</translation>
    </message>
    <message>
        <source>Address, name, key or a word from the help; if several words are entered, all must match</source>
        <translation>地址、名称、键名或说明中的词；输入多个词时须全部匹配</translation>
    </message>
    <message>
        <source>Shows all registers</source>
        <translation>显示全部参数</translation>
    </message>
    <message>
        <source>Shows registers that differ from the first reading of this session</source>
        <translation>显示自本次会话首次读取以来数值有变化的参数</translation>
    </message>
    <message>
        <source>Shows registers that differ from their known factory value</source>
        <translation>显示与已知出厂值不同的参数</translation>
    </message>
    <message>
        <source>Shows only one group of registers</source>
        <translation>只显示一组参数</translation>
    </message>
    <message>
        <source>Shows raw values before physical values and uses raw values for input</source>
        <translation>优先显示原始值，输入时也用原始值</translation>
    </message>
    <message>
        <source>Shows physical values before raw values and uses physical values for input</source>
        <translation>优先显示带单位的物理值，输入时也用物理值</translation>
    </message>
    <message>
        <source>How often the visible rows are read; nothing is written</source>
        <translation>可见行的读取频率；只读取，不写入</translation>
    </message>
    <message>
        <source>Shows everything that is known about the selected row</source>
        <translation>显示所选行的全部说明</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>原始值</translation>
    </message>
    <message>
        <source>Physical</source>
        <translation>物理值</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>As fast as the bus allows</source>
        <translation>总线允许的最快速度</translation>
    </message>
    <message>
        <source>Explain this &amp;row</source>
        <translation>解释此行(&amp;R)</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>&amp;Columns</source>
        <translation>列(&amp;C)</translation>
    </message>
    <message>
        <source>Copy, export or print the table, choose its columns, and set the live reading rate</source>
        <translation>复制、导出或打印表格，选择列，设置实时读取频率</translation>
    </message>
    <message>
        <source>&amp;Live reading: %1</source>
        <translation>实时读取(&amp;L)：%1</translation>
    </message>
</context>
<context>
    <name>ui::Menus</name>
    <message>
        <source>&amp;Port</source>
        <translation>端口(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Servo</source>
        <translation>舵机(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>主题(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
</context>
<context>
    <name>ui::MessageLine</name>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Latest message</source>
        <translation>最新消息</translation>
    </message>
</context>
<context>
    <name>ui::MessageLog</name>
    <message>
        <source>Messages</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>All messages since the program started</source>
        <translation>程序启动以来的全部消息</translation>
    </message>
    <message>
        <source>No messages yet.</source>
        <translation>尚无消息。</translation>
    </message>
</context>
<context>
    <name>ui::NoteDialog</name>
    <message>
        <source>Label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Short name shown in lists, for example “reference, tested”</source>
        <translation>列表中显示的简短名称，例如“参考，已测试”</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Additional information</source>
        <translation>其他补充信息</translation>
    </message>
    <message>
        <source>Discards the changes</source>
        <translation>放弃更改</translation>
    </message>
    <message>
        <source>Label and note</source>
        <translation>标签和备注</translation>
    </message>
    <message>
        <source>&amp;Label</source>
        <translation>标签(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Note</source>
        <translation>备注(&amp;N)</translation>
    </message>
    <message>
        <source>Saves the label and the note</source>
        <translation>保存标签和备注</translation>
    </message>
</context>
<context>
    <name>ui::NumberEditor</name>
    <message>
        <source>%1, in %2</source>
        <translation>%1，单位 %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1。%2</translation>
    </message>
</context>
<context>
    <name>ui::OperatePage</name>
    <message>
        <source>turns: %1</source>
        <translation>圈数：%1</translation>
    </message>
    <message>
        <source>turns since connecting: %1</source>
        <translation>连接后圈数：%1</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Position and goal</source>
        <translation>位置与目标</translation>
    </message>
    <message>
        <source>turns since connecting: %1 (uncertain)</source>
        <translation>连接后圈数：%1（不确定）</translation>
    </message>
</context>
<context>
    <name>ui::OperateStatus</name>
    <message>
        <source>Not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>no moving flag</source>
        <translation>无移动标志</translation>
    </message>
    <message>
        <source>moving: not read</source>
        <translation>移动：未读取</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>移动中</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>no alarm</source>
        <translation>无报警</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>尚未读取</translation>
    </message>
    <message>
        <source> · missed: %1</source>
        <translation> · 丢失：%1</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>Data age and reading rate</source>
        <translation>数据更新时间和读取频率</translation>
    </message>
    <message>
        <source>alarms: –</source>
        <translation>报警：–</translation>
    </message>
    <message>
        <source>Replies: %1 · timeouts: %2 · checksum errors: %3</source>
        <translation>应答：%1 · 超时：%2 · 校验错误：%3</translation>
    </message>
    <message>
        <source>Unreadable replies</source>
        <translation>应答无法识别</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>通信超时</translation>
    </message>
    <message>
        <source>Communication OK</source>
        <translation>通信正常</translation>
    </message>
    <message>
        <source>moving: unknown</source>
        <translation>移动：未知</translation>
    </message>
    <message>
        <source> — cleared</source>
        <translation> — 已解除</translation>
    </message>
    <message numerus="yes">
        <source>First seen at %1 · %n occurrence(s)</source>
        <translation>
            <numerusform>首次出现：%1，共 %n 次</numerusform>
        </translation>
    </message>
    <message>
        <source>Unknown: the servo does not reply, or its alarm status has not been read</source>
        <translation>未知：舵机没有应答，或报警状态尚未读取</translation>
    </message>
    <message>
        <source>updated %1 ago · %2 Hz</source>
        <translation>%1前更新 · %2 Hz</translation>
    </message>
    <message>
        <source>Removes cleared alarms from this list; active alarms stay</source>
        <translation>从列表中移除已解除的报警；尚未解除的报警会保留</translation>
    </message>
    <message>
        <source>Age of the latest value and number of readings in the last second</source>
        <translation>距最近一次读取的时间，以及最近一秒内的读取次数</translation>
    </message>
    <message>
        <source>Gauges</source>
        <translation>仪表</translation>
    </message>
    <message>
        <source>Shows or hides the gauges</source>
        <translation>显示或隐藏仪表</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Derived from the limits because this servo does not report alarms</source>
        <translation>根据限值判断得出，因为该舵机不上报报警</translation>
    </message>
</context>
<context>
    <name>ui::Pages</name>
    <message>
        <source>Operate</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Drive and monitor the servo</source>
        <translation>驱动并监视舵机</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>内存表</translation>
    </message>
    <message>
        <source>Read and safely write every setting in the servo&apos;s memory table</source>
        <translation>读取并安全地写入舵机内存表的每一项设置</translation>
    </message>
    <message>
        <source>Sweep test</source>
        <translation>扫描测试</translation>
    </message>
    <message>
        <source>Run a sweep test and evaluate the result</source>
        <translation>运行扫描测试并评估结果</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>阶跃响应</translation>
    </message>
    <message>
        <source>See how a servo responds to a step, and try other gains</source>
        <translation>查看舵机对阶跃的响应，并试用其他增益</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>快照</translation>
    </message>
    <message>
        <source>Save, compare and restore servo settings</source>
        <translation>保存、对比和恢复舵机的设置</translation>
    </message>
    <message>
        <source>Commissioning</source>
        <translation>批量设置</translation>
    </message>
    <message>
        <source>Set up servos one at a time</source>
        <translation>逐个接上并设置舵机</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史记录</translation>
    </message>
    <message>
        <source>All writes, snapshots, tests and alarms</source>
        <translation>所有写入、快照、测试和报警</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>Compare the firmware versions of the servos</source>
        <translation>比较各舵机的固件版本</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>机械臂</translation>
    </message>
    <message>
        <source>Calibrate a robot arm by moving its joints</source>
        <translation>通过转动关节校准机械臂</translation>
    </message>
</context>
<context>
    <name>ui::PortDialog</name>
    <message>
        <source>Other port</source>
        <translation>其他端口</translation>
    </message>
    <message>
        <source>Port path or TCP bridge address:</source>
        <translation>端口路径或 TCP 网桥地址：</translation>
    </message>
    <message>
        <source>/dev/ttyUSB0 or tcp://192.168.1.20:4000</source>
        <translation>/dev/ttyUSB0 或 tcp://192.168.1.20:4000</translation>
    </message>
    <message>
        <source>For example /dev/ttyUSB0, /dev/serial/by-id/…, tcp://192.168.1.20:4000, sim:sts3215@1,scs15@2</source>
        <translation>例如 /dev/ttyUSB0、/dev/serial/by-id/…、tcp://192.168.1.20:4000、sim:sts3215@1,scs15@2</translation>
    </message>
    <message>
        <source>Port or address</source>
        <translation>端口或地址</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Selects this port; click Connect to open it</source>
        <translation>选用此端口；点击“连接”打开</translation>
    </message>
    <message>
        <source>Keeps the previously selected port</source>
        <translation>保留原来选择的端口</translation>
    </message>
</context>
<context>
    <name>ui::PortPicker</name>
    <message>
        <source>Description: %1</source>
        <translation>说明：%1</translation>
    </message>
    <message>
        <source>Vendor: %1</source>
        <translation>制造商：%1</translation>
    </message>
    <message>
        <source>Serial number: %1</source>
        <translation>序列号：%1</translation>
    </message>
    <message>
        <source>USB %1:%2</source>
        <translation>USB %1:%2</translation>
    </message>
    <message>
        <source>Simulated bus: %1</source>
        <translation>模拟总线：%1</translation>
    </message>
    <message>
        <source>Simulated servos, no hardware needed</source>
        <translation>模拟舵机，无需硬件</translation>
    </message>
    <message>
        <source>Other port or TCP address…</source>
        <translation>其他端口或 TCP 地址…</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>%1 (not plugged in)</source>
        <translation>%1（未插入）</translation>
    </message>
    <message>
        <source>%1 is not plugged in; it stays selected</source>
        <translation>%1 未插入，但仍为所选端口</translation>
    </message>
    <message>
        <source>Enter a path such as /dev/ttyUSB0 or an address such as tcp://192.168.1.20:4000</source>
        <translation>输入路径（如 /dev/ttyUSB0）或地址（如 tcp://192.168.1.20:4000）</translation>
    </message>
    <message>
        <source>Select a port</source>
        <translation>请选择端口</translation>
    </message>
    <message>
        <source>Port to which the servos are connected</source>
        <translation>舵机所接的端口</translation>
    </message>
</context>
<context>
    <name>ui::PressGuard</name>
    <message>
        <source>Click ignored: this control had just moved on the screen. Click it again.</source>
        <translation>已忽略此次点击：此控件刚刚在屏幕上移动了位置。请再点一次。</translation>
    </message>
</context>
<context>
    <name>ui::RateChooser</name>
    <message>
        <source>Baud rates to search</source>
        <translation>要搜索的波特率</translation>
    </message>
    <message>
        <source>Select the baud rates to search; you can also use the space bar</source>
        <translation>勾选要搜索的波特率；也可按空格键勾选</translation>
    </message>
</context>
<context>
    <name>ui::RecordDialog</name>
    <message>
        <source>Record to</source>
        <translation>录制到</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Choose a file first.</source>
        <translation>请先指定文件。</translation>
    </message>
    <message>
        <source>This file already exists. Press Record again to replace it, or choose another name.</source>
        <translation>该文件已存在。再按一次“录制”即可替换该文件，也可换一个名称。</translation>
    </message>
    <message>
        <source>Table for spreadsheets (*.csv)</source>
        <translation>电子表格 (*.csv)</translation>
    </message>
    <message>
        <source>JSON Lines for programs (*.jsonl)</source>
        <translation>JSON Lines，供程序读取 (*.jsonl)</translation>
    </message>
    <message>
        <source>*.csv: a table; *.jsonl: one JSON object per line</source>
        <translation>*.csv：表格；*.jsonl：每行一个 JSON 对象</translation>
    </message>
    <message>
        <source>Opens a dialog to choose the folder and file name</source>
        <translation>打开对话框，选择文件夹和文件名</translation>
    </message>
    <message>
        <source>Channels shown in the chart</source>
        <translation>图中显示的通道</translation>
    </message>
    <message>
        <source>Records only what the chart shows</source>
        <translation>只录制图中显示的内容</translation>
    </message>
    <message>
        <source>All values that are read</source>
        <translation>读取到的所有数据</translation>
    </message>
    <message>
        <source>Includes values not shown in the chart</source>
        <translation>包括图中未显示的内容</translation>
    </message>
    <message>
        <source>Stop automatically after</source>
        <translation>录制以下时长后自动停止</translation>
    </message>
    <message>
        <source>If not selected, recording continues until you stop it</source>
        <translation>不勾选时，一直录制到手动停止为止</translation>
    </message>
    <message>
        <source>Duration in seconds from the first row</source>
        <translation>录制时长（秒），从第一行起算</translation>
    </message>
    <message>
        <source>Starts recording now</source>
        <translation>立即开始录制</translation>
    </message>
    <message>
        <source>Closes without recording</source>
        <translation>关闭对话框，不录制</translation>
    </message>
</context>
<context>
    <name>ui::RecordingControl</name>
    <message numerus="yes">
        <source>%1 · %Ln row(s)</source>
        <comment>time</comment>
        <translation>
            <numerusform>%1 · %Ln 行</numerusform>
        </translation>
    </message>
    <message>
        <source>The recording stopped: %1</source>
        <translation>录制已停止：%1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s) saved in %1. %2</source>
        <translation>
            <numerusform>已保存 %Ln 行到 %1。%2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s) recorded in %1</source>
        <translation>
            <numerusform>已录制 %Ln 行：%1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s) could not be stored because the disk was too slow.</source>
        <translation>
            <numerusform>因磁盘太慢，有 %Ln 行数据未能保存。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::RegisterDelegate</name>
    <message>
        <source>“%1” was not written because you left the cell without pressing Enter.</source>
        <translation>“%1”没有写入，因为离开单元格时没有按回车。</translation>
    </message>
</context>
<context>
    <name>ui::RegisterEditor</name>
    <message>
        <source>Press Enter to write or Esc to cancel.</source>
        <translation>按回车写入，按 Esc 取消。</translation>
    </message>
    <message>
        <source>Enter sends the value.</source>
        <translation>按回车发送该值。</translation>
    </message>
    <message>
        <source>Esc turns torque off on the whole bus and shows the present value again.</source>
        <translation>按 Esc 让整条总线卸力，并重新显示当前值。</translation>
    </message>
</context>
<context>
    <name>ui::RegisterPanel</name>
    <message>
        <source>Select a register to see what it does.</source>
        <translation>选择一个参数以查看说明。</translation>
    </message>
    <message>
        <source>State: %1</source>
        <translation>状态：%1</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>当前 %1</translation>
    </message>
    <message>
        <source>was %1</source>
        <translation>原值 %1</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>Write temporarily</source>
        <translation>临时写入</translation>
    </message>
    <message>
        <source>Register help</source>
        <translation>参数说明</translation>
    </message>
    <message>
        <source>Explains the selected register and lets you change it</source>
        <translation>说明所选参数的作用，也可在此修改</translation>
    </message>
    <message>
        <source>Writes this value and reads it back; the value is kept after power-off if the register supports permanent storage</source>
        <translation>写入该值并回读；如果该参数支持掉电保存，断电后仍保留</translation>
    </message>
    <message>
        <source>Writes the value without unlocking the EPROM; the value is lost at power-off</source>
        <translation>写入该值但不解锁 EPROM，断电后丢失</translation>
    </message>
</context>
<context>
    <name>ui::ReplayBar</name>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Time in the recording</source>
        <translation>录制文件中的时间</translation>
    </message>
    <message>
        <source>Plays the recording</source>
        <translation>播放录制文件</translation>
    </message>
    <message>
        <source>Position in the recording</source>
        <translation>录制文件中的位置</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>播放速度</translation>
    </message>
</context>
<context>
    <name>ui::RestorePanel</name>
    <message>
        <source>Torque is turned off first and stays off. Order: limits, mode, gains, then the lock. Every row is read back. The change can be undone.</source>
        <translation>先卸力并保持卸力。顺序：限值、模式、增益，最后上锁。每一行都会回读；之后仍可撤销。</translation>
    </message>
    <message>
        <source>Order: limits, mode, gains, then the lock. Every row is read back. The change can be undone.</source>
        <translation>顺序：限值、模式、增益，最后上锁。每一行都会回读；之后仍可撤销。</translation>
    </message>
    <message>
        <source>Write selected rows</source>
        <translation>写入勾选的行</translation>
    </message>
    <message numerus="yes">
        <source>Write %n selected row(s)</source>
        <translation>
            <numerusform>写入勾选的 %n 行</numerusform>
        </translation>
    </message>
    <message>
        <source>Restore the bundle…</source>
        <translation>恢复整组快照…</translation>
    </message>
    <message>
        <source>Several servos…</source>
        <translation>多个舵机…</translation>
    </message>
    <message>
        <source>%1: this limit comes from another model (%2).</source>
        <translation>%1：该限值来自其他型号（%2）。</translation>
    </message>
    <message>
        <source>%1: a wrong value can make the servo unreachable or dangerous.</source>
        <translation>%1：错误的值可能使舵机失联或造成危险。</translation>
    </message>
    <message>
        <source>%1 shifts the position that the servo reports.</source>
        <translation>%1 会改变舵机反馈的位置。</translation>
    </message>
    <message>
        <source>%1 changes from %2 to %3. Afterwards, the servo can be reached only with the new setting.</source>
        <translation>%1 从 %2 改为 %3。之后只能以新设置与舵机通信。</translation>
    </message>
    <message>
        <source>Write to ID %1?</source>
        <translation>向 ID %1 的舵机写入？</translation>
    </message>
    <message>
        <source>Torque is on; it will be turned off first and will stay off. A load held by the servo may drop.</source>
        <translation>扭矩已打开；写入前会先卸力，并保持卸力。舵机托住的负载可能掉落。</translation>
    </message>
    <message>
        <source>Write anyway</source>
        <translation>仍要写入</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>Save the result</source>
        <translation>保存结果</translation>
    </message>
    <message>
        <source>Data (*.json)</source>
        <translation>数据 (*.json)</translation>
    </message>
    <message>
        <source>Include ID and baud rate</source>
        <translation>包括 ID 和波特率</translation>
    </message>
    <message>
        <source>Also selects ID and baud rate, which are written last; the servo can then be reached only with the new settings</source>
        <translation>同时勾选 ID 和波特率，这两项最后写入；之后只能以新设置与舵机通信</translation>
    </message>
    <message>
        <source>If a row fails, restore all old values</source>
        <translation>如果有一行写入失败，全部恢复原值</translation>
    </message>
    <message>
        <source>Without this option, writing stops at the failed row; values already written stay in the servo</source>
        <translation>不勾选时，写入会在失败的那一行停止，已写入的值保留在舵机中</translation>
    </message>
    <message>
        <source>Writes only the selected rows that differ from the servo&apos;s present values</source>
        <translation>只写入已勾选且与舵机当前值不同的行</translation>
    </message>
    <message>
        <source>Dry run…</source>
        <translation>预演…</translation>
    </message>
    <message>
        <source>Shows exactly what would be written, and in which order</source>
        <translation>准确显示将要写入的内容和写入顺序</translation>
    </message>
    <message>
        <source>Writes the selected rows to several servos</source>
        <translation>把勾选的行写入多个舵机</translation>
    </message>
    <message>
        <source>Save template…</source>
        <translation>保存模板…</translation>
    </message>
    <message>
        <source>Saves selected rows of this snapshot to a file for setting up other servos</source>
        <translation>选择此快照中的若干行保存为文件，用于设置其他舵机</translation>
    </message>
    <message>
        <source>Save result…</source>
        <translation>保存结果…</translation>
    </message>
    <message>
        <source>%1: with both angle limits at 0, the shaft can turn without limit.</source>
        <translation>%1：两个角度限制均为 0 时，输出轴的转动不受限制。</translation>
    </message>
    <message>
        <source>Table for spreadsheets (*.csv)</source>
        <translation>电子表格 (*.csv)</translation>
    </message>
</context>
<context>
    <name>ui::RunListDialog</name>
    <message>
        <source>Model, firmware, label, note, operator or port</source>
        <translation>型号、固件、标签、备注、操作员或端口</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Shows only tests that contain this text</source>
        <translation>仅显示含此文字的测试</translation>
    </message>
    <message>
        <source>Earlier tests</source>
        <translation>以往测试</translation>
    </message>
    <message>
        <source>One row for each servo in a test, newest first</source>
        <translation>测试中每个舵机一行，最新的在前</translation>
    </message>
    <message>
        <source>Label…</source>
        <translation>标签…</translation>
    </message>
    <message>
        <source>Labels the servo in the selected test; servos have no serial number to identify them</source>
        <translation>为所选测试中的舵机加标签（舵机没有序列号）</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>删除…</translation>
    </message>
    <message>
        <source>Deletes the selected tests from the history</source>
        <translation>从历史记录中删除所选测试</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Closes this window</source>
        <translation>关闭此窗口</translation>
    </message>
    <message>
        <source>No tests yet. All tests run in this program or from the command line are stored here.</source>
        <translation>还没有测试。在本程序或命令行中运行的测试都保存在这里。</translation>
    </message>
    <message>
        <source>No test matches this filter.</source>
        <translation>没有符合筛选条件的测试。</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Label of this servo, as written on it:</source>
        <translation>此舵机的标签（与舵机上写的一致）：</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n test(s)?</source>
        <translation>
            <numerusform>删除 %n 次测试？</numerusform>
        </translation>
    </message>
    <message>
        <source>This cannot be undone.</source>
        <translation>此操作无法撤销。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation>%1（模拟）</translation>
    </message>
    <message>
        <source>ignored: did not finish</source>
        <translation>已忽略：测试未完成</translation>
    </message>
    <message>
        <source>ignored: failed</source>
        <translation>已忽略：不合格</translation>
    </message>
    <message>
        <source>★ reference</source>
        <translation>★ 参考</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试编号</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
</context>
<context>
    <name>ui::RunsDialog</name>
    <message>
        <source>Earlier tests</source>
        <translation>以往测试</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>保存报告…</translation>
    </message>
    <message>
        <source>Compare two</source>
        <translation>对比两次测试</translation>
    </message>
    <message>
        <source>Clear reference</source>
        <translation>取消参考</translation>
    </message>
    <message>
        <source>Mark as reference</source>
        <translation>设为参考</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>Compared with the reference %1 (test %2, %3):</source>
        <translation>与参考 %1（测试 %2，%3）对比：</translation>
    </message>
    <message>
        <source>This test did not finish, so it cannot be a reference</source>
        <translation>此测试未完成，不能设为参考</translation>
    </message>
    <message>
        <source>This servo failed the test, so it cannot be a reference</source>
        <translation>该舵机测试不合格，不能设为参考</translation>
    </message>
    <message>
        <source>Saves the report of the selected test as a web page</source>
        <translation>将所选测试的报告保存为网页</translation>
    </message>
    <message>
        <source>Compares the two selected tests; A is the one marked as reference, otherwise the older one</source>
        <translation>对比所选的两次测试；标为参考的一次为 A，如果都未标为参考，则较早的一次为 A</translation>
    </message>
    <message>
        <source>Uses this servo&apos;s test as the reference for later tests of this model; each model has one reference</source>
        <translation>以后此型号的测试都与此舵机对比；每个型号只有一个参考</translation>
    </message>
    <message>
        <source>Stops using this servo as the reference</source>
        <translation>不再以此舵机作为参考</translation>
    </message>
    <message>
        <source>Select two rows to compare them. Servos have no serial number; they are identified by model, firmware, ID and label.</source>
        <translation>选择两行即可对比。舵机没有序列号：只能按型号、固件、ID 和您的标签区分。</translation>
    </message>
    <message>
        <source>The metrics, moves and settings of all servos in these tests are deleted from the history. Saved report and data files are kept.</source>
        <translation>这些测试中所有舵机的指标、行程和设置将从历史记录中删除。已保存的报告文件和数据文件会保留。</translation>
    </message>
    <message>
        <source>The reference %1 (test %2, %3) is ignored because that test did not finish. Under Earlier tests, mark a completed test as the reference.</source>
        <translation>已忽略参考 %1（测试 %2，%3）：该测试未完成。请在“以往测试”中将已完成的测试设为参考。</translation>
    </message>
    <message>
        <source>no metric differs by 10 % or more</source>
        <translation>没有指标相差 10% 或以上</translation>
    </message>
</context>
<context>
    <name>ui::SearchPanel</name>
    <message>
        <source> · at %1</source>
        <translation> · %1</translation>
    </message>
    <message>
        <source> · about %1</source>
        <translation> · 约 %1</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Search progress</source>
        <translation>搜索进度</translation>
    </message>
    <message>
        <source>Servos</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>No servos in the list yet. Search the bus.</source>
        <translation>列表中还没有舵机，请搜索总线。</translation>
    </message>
    <message>
        <source>Commissioning is running. Its servos are shown on the Commissioning page.</source>
        <translation>批量设置正在进行，舵机显示在“批量设置”页。</translation>
    </message>
    <message numerus="yes">
        <source>%1 % · %n servo(s) · %2 left</source>
        <translation>
            <numerusform>%1% · %n 个舵机 · 剩余 %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Starting the search…</source>
        <translation>开始搜索…</translation>
    </message>
    <message numerus="yes">
        <source>Stopped after %1 · %n servo(s)</source>
        <translation>
            <numerusform>已停止，用时 %1 · %n 个舵机</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Search took %1 · %n servo(s)</source>
        <translation>
            <numerusform>搜索用时 %1 · %n 个舵机</numerusform>
        </translation>
    </message>
    <message>
        <source>Some servos replied late, so others may have been missed. Select &quot;Wait longer&quot; and search again.</source>
        <translation>部分舵机应答迟缓，可能还有舵机未搜到。请勾选“延长等待”后再次搜索。</translation>
    </message>
    <message numerus="yes">
        <source>%n ID(s) to search</source>
        <translation>
            <numerusform>%n 个 ID</numerusform>
        </translation>
    </message>
    <message>
        <source> · baud rates: %1</source>
        <translation> · %1 种波特率</translation>
    </message>
    <message>
        <source>Search time if no servos are found</source>
        <translation>未搜到舵机时所需的搜索时间</translation>
    </message>
    <message>
        <source>How much of the search is complete</source>
        <translation>搜索的完成比例</translation>
    </message>
    <message>
        <source>Servos that have replied; selecting one only reads it; hold Ctrl or Shift to select several servos and move them together</source>
        <translation>有应答的舵机；选中时只读取，不写入；按住 Ctrl 或 Shift 可选择多个舵机，让所选舵机一起运动</translation>
    </message>
    <message>
        <source>Servos appear here when they are found.</source>
        <translation>搜索到的舵机会显示在这里。</translation>
    </message>
    <message>
        <source>Servos missing? Find out why…</source>
        <translation>舵机没搜全？查找原因…</translation>
    </message>
    <message>
        <source>Find out why…</source>
        <translation>查找原因…</translation>
    </message>
    <message>
        <source>No servo replied.</source>
        <translation>没有舵机应答。</translation>
    </message>
</context>
<context>
    <name>ui::SearchScope</name>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>First ID</source>
        <translation>起始 ID</translation>
    </message>
    <message>
        <source>Last ID</source>
        <translation>结束 ID</translation>
    </message>
    <message>
        <source>Current protocol</source>
        <translation>当前协议</translation>
    </message>
    <message>
        <source>All protocols</source>
        <translation>全部协议</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>协议</translation>
    </message>
    <message>
        <source>Wait longer</source>
        <translation>延长等待</translation>
    </message>
    <message>
        <source>First ID to search</source>
        <translation>搜索的起始 ID</translation>
    </message>
    <message>
        <source>Last ID to search</source>
        <translation>搜索的结束 ID</translation>
    </message>
    <message>
        <source>Current baud rate</source>
        <translation>当前波特率</translation>
    </message>
    <message>
        <source>Selected baud rates</source>
        <translation>所选波特率</translation>
    </message>
    <message>
        <source>All baud rates</source>
        <translation>全部波特率</translation>
    </message>
    <message>
        <source>Baud rates</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>Baud rates to search; the port&apos;s own baud rate is restored afterwards</source>
        <translation>搜索哪些波特率；结束后恢复端口原来的波特率</translation>
    </message>
    <message>
        <source>The other end of the TCP connection sets the baud rate</source>
        <translation>波特率由 TCP 连接的另一端决定</translation>
    </message>
    <message>
        <source>Select baud rates</source>
        <translation>选择波特率</translation>
    </message>
    <message>
        <source>Select the baud rates to search</source>
        <translation>勾选要搜索的波特率</translation>
    </message>
    <message>
        <source>Protocols to search with</source>
        <translation>搜索时使用的协议</translation>
    </message>
    <message>
        <source>Queries silent IDs again with a longer timeout, for adapters that reply late</source>
        <translation>用较长超时再次询问无应答的 ID，适用于应答迟缓的适配器</translation>
    </message>
</context>
<context>
    <name>ui::SelfTest</name>
    <message>
        <source>Search the simulated bus</source>
        <translation>搜索模拟总线</translation>
    </message>
    <message>
        <source>no servos were found</source>
        <translation>没有找到舵机</translation>
    </message>
    <message>
        <source>Open the page %1</source>
        <translation>打开页面：%1</translation>
    </message>
    <message>
        <source>the page is not shown</source>
        <translation>页面没有显示</translation>
    </message>
    <message>
        <source>Read the memory table</source>
        <translation>读取内存表</translation>
    </message>
    <message>
        <source>it could not be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>Write a register</source>
        <translation>写入参数</translation>
    </message>
    <message>
        <source>the servo has another value</source>
        <translation>舵机中的值不同</translation>
    </message>
    <message>
        <source>Undo the write</source>
        <translation>撤销写入</translation>
    </message>
    <message>
        <source>it did not finish</source>
        <translation>没有完成</translation>
    </message>
    <message>
        <source>Run a sweep test</source>
        <translation>运行扫描测试</translation>
    </message>
    <message>
        <source>it did not start</source>
        <translation>没有开始</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>the report is not complete</source>
        <translation>报告不完整</translation>
    </message>
    <message>
        <source>it did not end</source>
        <translation>没有结束</translation>
    </message>
    <message numerus="yes">
        <source>ServoDesk works: %n step(s) in %1 s.</source>
        <translation>
            <numerusform>ServoDesk 工作正常：%n 个步骤，用时 %1 秒。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ServoHistoryModel</name>
    <message>
        <source>Written temporarily: lost at power-off.</source>
        <translation>临时写入：断电后丢失。</translation>
    </message>
    <message>
        <source>Written and read back.</source>
        <translation>已写入并回读确认。</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>撤销：%1</translation>
    </message>
    <message>
        <source>Not finished: still being written, or interrupted.</source>
        <translation>未写完：正在写入，或已中断。</translation>
    </message>
    <message>
        <source>Started, then undone: the old value was restored.</source>
        <translation>写入已开始，后被撤销：已恢复原值。</translation>
    </message>
    <message>
        <source>Abandoned: neither finished nor undone.</source>
        <translation>已放弃：写入既未完成，也未撤销。</translation>
    </message>
    <message>
        <source>The write did not end as expected.</source>
        <translation>写入未按预期结束。</translation>
    </message>
</context>
<context>
    <name>ui::ServoHistoryPanel</name>
    <message>
        <source>History of this servo</source>
        <translation>本舵机的历史记录</translation>
    </message>
    <message>
        <source>No writes to this servo have been recorded. Servos are identified by model, firmware and ID.</source>
        <translation>没有这个舵机的写入记录。舵机按型号、固件和 ID 识别。</translation>
    </message>
    <message>
        <source>Select a servo on the left to see what was written to it.</source>
        <translation>请在左侧选择舵机，以查看该舵机的写入记录。</translation>
    </message>
    <message>
        <source>Writes to this servo, newest first, including those made under its earlier IDs</source>
        <translation>这个舵机的写入记录，最新的在前；也包括该舵机使用旧 ID 时的记录</translation>
    </message>
</context>
<context>
    <name>ui::ServoListModel</name>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>Register map</source>
        <translation>内存表</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>最近应答</translation>
    </message>
    <message>
        <source>Bus type</source>
        <translation>总线类型</translation>
    </message>
</context>
<context>
    <name>ui::ServoStrip</name>
    <message>
        <source>All servos</source>
        <translation>所有舵机</translation>
    </message>
</context>
<context>
    <name>ui::ShortcutsDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Lists all shortcuts</source>
        <translation>列出全部快捷键</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>说明</translation>
    </message>
    <message>
        <source>All torque off</source>
        <translation>全部卸力</translation>
    </message>
    <message>
        <source>Immediately turns torque off on the whole bus. In a field of the motion panel, Esc also shows the present value again. In a menu, a dialog or a table cell being edited, the first Esc only closes the menu or dialog or cancels the edit. While servos are moving or jammed, Esc stops them even from a menu or a dialog.</source>
        <translation>立即让整条总线卸力。在运动面板的输入框中，Esc 还会重新显示当前值。在菜单、对话框或正在编辑的单元格中，第一次按 Esc 只关闭菜单或对话框，或取消编辑。但有舵机正在运动或被卡住时，即使在菜单或对话框中，按 Esc 也会立即卸力。</translation>
    </message>
    <message>
        <source>Immediately turns torque off on the whole bus; works everywhere</source>
        <translation>立即让整条总线卸力；在任何界面都有效</translation>
    </message>
</context>
<context>
    <name>ui::SnapshotActions</name>
    <message>
        <source>Open snapshots</source>
        <translation>打开快照</translation>
    </message>
    <message>
        <source>Snapshots and bundles (*.servo.json *.bundle.json)</source>
        <translation>快照和整组快照 (*.servo.json *.bundle.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Save the snapshot</source>
        <translation>保存快照</translation>
    </message>
    <message>
        <source>Snapshot (*.servo.json)</source>
        <translation>快照 (*.servo.json)</translation>
    </message>
    <message>
        <source>Table for spreadsheets (*.csv)</source>
        <translation>电子表格 (*.csv)</translation>
    </message>
    <message>
        <source>Save snapshots of all servos</source>
        <translation>保存所有舵机的快照</translation>
    </message>
    <message>
        <source>Bundle (*.bundle.json)</source>
        <translation>整组快照 (*.bundle.json)</translation>
    </message>
    <message>
        <source>Save the template</source>
        <translation>保存模板</translation>
    </message>
    <message>
        <source>Template (*.servo.json)</source>
        <translation>模板 (*.servo.json)</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n snapshot(s)?</source>
        <translation>
            <numerusform>删除 %n 份快照？</numerusform>
        </translation>
    </message>
    <message>
        <source>This affects only the history on this computer. Files are not deleted.</source>
        <translation>仅影响本机的历史记录，不会删除文件。</translation>
    </message>
    <message>
        <source>This cannot be undone.</source>
        <translation>此操作无法撤销。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Take snapshot</source>
        <translation>保存快照</translation>
    </message>
    <message>
        <source>Reads the whole memory table of the selected servo and saves it in the history</source>
        <translation>读取所选舵机的整个内存表并存入历史记录</translation>
    </message>
    <message>
        <source>Open file…</source>
        <translation>打开文件…</translation>
    </message>
    <message>
        <source>Opens snapshots, templates or bundles; they can also be dropped here</source>
        <translation>打开快照、模板或整组快照；也可拖放到这里</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>Save, label or delete a snapshot; save all servos</source>
        <translation>保存、标注或删除快照；保存所有舵机的设置</translation>
    </message>
    <message>
        <source>Save as file…</source>
        <translation>另存为文件…</translation>
    </message>
    <message>
        <source>Label and note…</source>
        <translation>标签和备注…</translation>
    </message>
    <message>
        <source>Save all servos as a bundle…</source>
        <translation>为所有舵机保存整组快照…</translation>
    </message>
    <message>
        <source>Delete from the history…</source>
        <translation>从历史记录中删除…</translation>
    </message>
    <message>
        <source>Printable page (*.pdf)</source>
        <translation>可打印页面 (*.pdf)</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
</context>
<context>
    <name>ui::SnapshotBrowser</name>
    <message>
        <source>Snapshots</source>
        <translation>快照</translation>
    </message>
    <message>
        <source>This servo</source>
        <translation>此舵机</translation>
    </message>
    <message>
        <source>All servos</source>
        <translation>所有舵机</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Search snapshots</source>
        <translation>搜索快照</translation>
    </message>
    <message>
        <source>%1, ID %2</source>
        <translation>%1，ID %2</translation>
    </message>
    <message>
        <source>Snapshots to show</source>
        <translation>显示哪些快照</translation>
    </message>
    <message>
        <source>Shows only snapshots whose model and ID match the selected servo, or all snapshots (servos have no serial number)</source>
        <translation>只显示型号和 ID 与所选舵机相同的快照，或显示全部快照（舵机没有序列号）</translation>
    </message>
    <message>
        <source>The selected snapshot is used for comparing and restoring; Ctrl+click adds snapshots to the comparison</source>
        <translation>所选快照用于对比和恢复；按住 Ctrl 点击可添加更多快照进行对比</translation>
    </message>
    <message>
        <source>Searches the model, label, note and file name</source>
        <translation>在型号、标签、备注和文件名中搜索</translation>
    </message>
    <message>
        <source>No snapshots yet. Take one here; one is also saved automatically before the first change to a servo.</source>
        <translation>还没有快照。可在此保存一份；首次更改舵机之前也会自动保存。</translation>
    </message>
    <message>
        <source>No snapshot matches.</source>
        <translation>没有匹配的快照。</translation>
    </message>
    <message>
        <source>No snapshots of this servo yet. Take one here; one is also saved automatically before the first change.</source>
        <translation>此舵机还没有快照。可在此保存一份；首次更改之前也会自动保存。</translation>
    </message>
</context>
<context>
    <name>ui::SnapshotPane</name>
    <message>
        <source>≠ %1 different</source>
        <translation>≠ %1 项不同</translation>
    </message>
    <message>
        <source>All rows</source>
        <translation>所有行</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>对比列</translation>
    </message>
    <message>
        <source>≠ %1 never restored</source>
        <translation>≠ %1 项不恢复</translation>
    </message>
    <message>
        <source>= no differences</source>
        <translation>= 设置全部相同</translation>
    </message>
    <message>
        <source>= no differences at that time</source>
        <translation>= 当时设置全部相同</translation>
    </message>
    <message>
        <source>= %1 identical</source>
        <translation>= %1 项相同</translation>
    </message>
    <message>
        <source>%1 read-only, %2 missing, %3 unknown</source>
        <translation>%1 项只读，%2 项缺少，%3 项未知</translation>
    </message>
    <message numerus="yes">
        <source>%n other(s)</source>
        <translation>
            <numerusform>其他 %n 项</numerusform>
        </translation>
    </message>
    <message>
        <source>No writable setting differs.</source>
        <translation>可写设置均无差异。</translation>
    </message>
    <message>
        <source>No writable setting differed when the servo was last read.</source>
        <translation>上次读取舵机时，可写设置均无差异。</translation>
    </message>
    <message>
        <source>Shows identical and read-only rows too</source>
        <translation>也显示相同的行和只读的行</translation>
    </message>
    <message>
        <source>Adds the factory defaults or other servos to the comparison; Ctrl+click snapshots to add them too</source>
        <translation>将出厂默认值或其他舵机加入对比；要加入更多快照，请按住 Ctrl 点击快照</translation>
    </message>
    <message>
        <source>Memory tables side by side</source>
        <translation>并排的内存表</translation>
    </message>
    <message>
        <source>The space bar selects a row for writing</source>
        <translation>按空格键勾选一行；勾选的行会被写入</translation>
    </message>
</context>
<context>
    <name>ui::SnapshotsPage</name>
    <message>
        <source>Snapshots</source>
        <translation>快照</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>another model</source>
        <translation>其他型号</translation>
    </message>
    <message>
        <source>Select a servo in the list or a snapshot on the left.</source>
        <translation>请在列表中选择舵机，或在左侧选择快照。</translation>
    </message>
    <message>
        <source>Reading the servo&apos;s memory table…</source>
        <translation>正在读取舵机的内存表…</translation>
    </message>
    <message>
        <source>Select a snapshot on the left to compare the servo with it, or open a file.</source>
        <translation>请在左侧选择要与舵机对比的快照，或打开文件。</translation>
    </message>
    <message>
        <source>Bundle (servos: %1); select a servo to compare it</source>
        <translation>整组快照（舵机数：%1）；选择其中一个舵机即可对比</translation>
    </message>
    <message>
        <source>%1 vs. %2</source>
        <translation>%1 与 %2 对比</translation>
    </message>
    <message>
        <source>Snapshot of ID %1 · %2 saved: %3 registers.</source>
        <translation>已保存快照：ID %1 · %2，%3 个参数。</translation>
    </message>
</context>
<context>
    <name>ui::StepForm</name>
    <message>
        <source>Step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>往返次数</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Raw value, or a value with its unit (30deg); if the value is negative, the servo first moves toward lower positions</source>
        <translation>原始值，或带单位的值（30deg）；负值表示先朝位置减小的方向运动</translation>
    </message>
    <message>
        <source>Start position of the step; leave empty to use the present position, or the nearest one with enough room</source>
        <translation>阶跃的起始位置；留空：使用当前位置，如果空间不足，则使用最近的可用位置</translation>
    </message>
    <message>
        <source>Number of back-and-forth steps</source>
        <translation>往返次数</translation>
    </message>
    <message>
        <source>Time from one goal to the next; 0: as long as the step takes</source>
        <translation>从一个目标到下一个目标的时间；0：按阶跃所需时间自动确定</translation>
    </message>
    <message>
        <source>Raw value, or a value with its unit; leave empty for the maximum (the previous value is restored after the run)</source>
        <translation>原始值，或带单位的值；留空则使用最大值（运行结束后恢复原值）</translation>
    </message>
    <message>
        <source>present position</source>
        <translation>当前位置</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
</context>
<context>
    <name>ui::StepGains</name>
    <message>
        <source>This servo family has no gains to set.</source>
        <translation>该系列舵机没有可设置的增益。</translation>
    </message>
    <message>
        <source>%1: value to try</source>
        <translation>%1：试用值</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Select a servo to see its gains.</source>
        <translation>请选择舵机以查看增益。</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>试用</translation>
    </message>
    <message>
        <source>%1 … %2; used only for trials until you click Keep gains</source>
        <translation>%1～%2；点击“保留增益”之前仅用于试用</translation>
    </message>
</context>
<context>
    <name>ui::StepPage</name>
    <message>
        <source>Connect to a port first.</source>
        <translation>请先连接端口。</translation>
    </message>
    <message>
        <source>Start the run?</source>
        <translation>开始运行？</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>阶跃响应</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Switch to position mode for the run</source>
        <translation>运行期间切换到位置模式</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>运行进度</translation>
    </message>
    <message>
        <source>%1 %2 (old value %3)</source>
        <translation>%1 %2（原值 %3）</translation>
    </message>
    <message>
        <source>The old values are recorded in the journal. When the servo replies again, restore them under Port → Interrupted writes. At power-off, the servo discards the trial values.</source>
        <translation>原值已记入写入日志。舵机恢复应答后，请在“端口 → 未写完的更改”中恢复原值。断电后舵机会自行丢弃试用值。</translation>
    </message>
    <message>
        <source>Select a servo in the list.</source>
        <translation>请在列表中选择舵机。</translation>
    </message>
    <message>
        <source>This servo could not be identified, so ServoDesk does not move it.</source>
        <translation>无法识别该舵机，ServoDesk 不会驱动它。</translation>
    </message>
    <message>
        <source>A search is running; you can start the run after it ends.</source>
        <translation>正在搜索；搜索结束后才能开始运行。</translation>
    </message>
    <message>
        <source>Another test is running.</source>
        <translation>另一项测试正在运行。</translation>
    </message>
    <message>
        <source>The servo is in a mode that does not use positions. Select &quot;Switch to position mode for the run&quot; or change the mode yourself.</source>
        <translation>该舵机当前的运行模式不是位置控制。请勾选“运行期间切换到位置模式”，或自行更改模式。</translation>
    </message>
    <message>
        <source>Enter the step size.</source>
        <translation>请填写阶跃大小。</translation>
    </message>
    <message>
        <source>The servo is moving. Esc turns torque off on all servos.</source>
        <translation>舵机正在运动。按 Esc 让所有舵机卸力。</translation>
    </message>
    <message>
        <source>Torque is turned on for ID %1 · %2, and the servo moves by itself at maximum speed until the run has ended.</source>
        <translation>ID %1 · %2 将打开扭矩并以最高速度自行运动，直到运行结束。</translation>
    </message>
    <message>
        <source>Afterwards, the servo holds its position with torque on, even if you stop the run or close the window.</source>
        <translation>结束后舵机保持位置，扭矩保持打开。中途停止运行或关闭窗口也是如此。</translation>
    </message>
    <message>
        <source>Keep hands and objects away from the servo. Esc immediately turns torque off on all servos.</source>
        <translation>请让双手和物体远离舵机的运动范围。按 Esc 立即让所有舵机卸力。</translation>
    </message>
    <message>
        <source>Trial values are still in the servo: %1.</source>
        <translation>试用值仍在舵机中：%1。</translation>
    </message>
    <message>
        <source>The settings that were changed for the run could not be restored.</source>
        <translation>为本次运行所更改的设置未能恢复。</translation>
    </message>
    <message>
        <source>Ends the run; the servo holds its position</source>
        <translation>结束运行；舵机保持在当前位置</translation>
    </message>
    <message>
        <source>Switches back after the run; nothing is stored permanently in the servo</source>
        <translation>运行结束后切换回原模式；舵机中不会永久保存任何改动</translation>
    </message>
    <message>
        <source>Change a value under Trial first.</source>
        <translation>请先修改“试用”列中的值。</translation>
    </message>
    <message>
        <source>Measures the same step with these values and restores the old values afterwards: %1</source>
        <translation>用以下数值测量同样的阶跃，之后恢复原值：%1</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Restore old values</source>
        <translation>恢复原值</translation>
    </message>
    <message>
        <source>Resets the values under Trial to the present values</source>
        <translation>将“试用”列恢复为当前值</translation>
    </message>
    <message>
        <source>Writes the gains that were set before the last change: %1</source>
        <translation>写回上次更改之前的增益：%1</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Measures the step with the servo&apos;s present gains: the servo will move</source>
        <translation>用舵机当前的增益执行阶跃：舵机会运动</translation>
    </message>
    <message>
        <source>Try gains</source>
        <translation>试用增益</translation>
    </message>
    <message>
        <source>Keep gains</source>
        <translation>保留增益</translation>
    </message>
    <message>
        <source>Permanently writes the values listed under Trial</source>
        <translation>将“试用”列的值永久写入</translation>
    </message>
    <message>
        <source>Movement is blocked by the emergency stop, and torque is off. Click Allow movement to turn torque on; nothing moves until you click Measure or Try gains.</source>
        <translation>急停后已卸力，禁止运动。点击“允许运动”可打开扭矩；点击“测量”或“试用增益”之前，舵机不会运动。</translation>
    </message>
    <message>
        <source>ID %1 moves when you click Measure or Try gains.</source>
        <translation>点击“测量”或“试用增益”会使 ID %1 运动。</translation>
    </message>
</context>
<context>
    <name>ui::StepResults</name>
    <message>
        <source>%1, return</source>
        <translation>%1，回程</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>原参数</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>步</translation>
    </message>
    <message>
        <source>Save the runs</source>
        <translation>保存运行结果</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Metrics before and after</source>
        <translation>更改前后的指标对比</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>变化</translation>
    </message>
    <message>
        <source>&lt;b&gt;What to try next&lt;/b&gt;</source>
        <translation>&lt;b&gt;下一步建议&lt;/b&gt;</translation>
    </message>
    <message>
        <source>%1, outbound</source>
        <translation>%1，去程</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>填入“试用”</translation>
    </message>
    <message>
        <source>Step to show for each run</source>
        <translation>显示每次运行的哪一次阶跃</translation>
    </message>
    <message>
        <source>Overlaid step responses</source>
        <translation>阶跃响应叠加图</translation>
    </message>
    <message>
        <source>Mean of all steps in a run, out and back</source>
        <translation>一次运行中所有往返阶跃的平均值</translation>
    </message>
    <message>
        <source>%1 (interrupted)</source>
        <translation>%1（提前结束）</translation>
    </message>
    <message>
        <source>These results do not suggest any changes.</source>
        <translation>从这些结果看，无需调整参数。</translation>
    </message>
    <message>
        <source>Saves these runs as %1</source>
        <translation>将这些运行结果保存为 %1</translation>
    </message>
    <message>
        <source>Test %1</source>
        <translation>测试 %1</translation>
    </message>
    <message>
        <source>Test %1 (%2): %3</source>
        <translation>测试 %1（%2）：%3</translation>
    </message>
    <message>
        <source>The steps differ in size, so their metrics are not compared.</source>
        <translation>阶跃大小不同，不对比各项指标。</translation>
    </message>
    <message>
        <source>Earlier runs…</source>
        <translation>以往的运行…</translation>
    </message>
    <message>
        <source>Lists the stored step responses; you can open one or compare two</source>
        <translation>列出已保存的阶跃响应；可打开其中一次，或对比两次</translation>
    </message>
    <message>
        <source>Removes these runs from the page; the servo and the history do not change</source>
        <translation>从本页移除这些运行结果；舵机和历史记录不变</translation>
    </message>
    <message>
        <source>Copies this value to Trial; nothing is written</source>
        <translation>将此值填入“试用”列；不写入舵机</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>响应</translation>
    </message>
    <message>
        <source>Response — %1</source>
        <translation>响应 — %1</translation>
    </message>
    <message>
        <source>Movement in steps from the start toward the goal, on the way out and on the way back</source>
        <translation>从起始位置朝目标方向走过的步数；去程和回程的计法相同</translation>
    </message>
    <message>
        <source>Click Measure to record the servo&apos;s step response. Then change a gain under Trial and click Try gains to compare.</source>
        <translation>点击“测量”记录舵机的阶跃响应；然后修改“试用”列中的增益，点击“试用增益”进行比较。</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>试用</translation>
    </message>
    <message>
        <source>After</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>%1 (already measured)</source>
        <translation>%1（已测量）</translation>
    </message>
</context>
<context>
    <name>ui::StepRunsDialog</name>
    <message>
        <source>Earlier step responses</source>
        <translation>以往阶跃响应</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Shows the selected run on the Step response page, or compares two selected runs there</source>
        <translation>在“阶跃响应”页显示所选的一次运行，或对比所选的两次运行</translation>
    </message>
    <message>
        <source>Select one run to open it, or two to compare them.</source>
        <translation>选择一次运行即可打开，选择两次即可对比。</translation>
    </message>
    <message>
        <source>The metrics, responses and settings of these runs are deleted from the history. Report files are kept.</source>
        <translation>将从历史记录中删除所选各次运行的指标、响应和设置。报告文件会保留。</translation>
    </message>
</context>
<context>
    <name>ui::StepStrip</name>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>第 %1 步，共 %2 步：%3</translation>
    </message>
</context>
<context>
    <name>ui::SweepEndConditions</name>
    <message>
        <source>End early on</source>
        <translation>提前结束条件</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Any alarm that the servo reports, such as an over-temperature, overload or voltage alarm</source>
        <translation>舵机报告的任何报警，如过温、过载或过压欠压</translation>
    </message>
    <message>
        <source>Stall</source>
        <translation>堵转</translation>
    </message>
    <message>
        <source>The servo stops too far from its goal</source>
        <translation>舵机停止时离目标过远</translation>
    </message>
    <message>
        <source>First failure</source>
        <translation>首个不合格项</translation>
    </message>
    <message>
        <source>A metric is beyond its limit; checked after every cycle</source>
        <translation>有指标超出限值；每个循环后判定</translation>
    </message>
</context>
<context>
    <name>ui::SweepForm</name>
    <message>
        <source>Sweep</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>正弦</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>随机</translation>
    </message>
    <message>
        <source>List</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>End</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>周期</translation>
    </message>
    <message>
        <source>Next goal</source>
        <translation>下一目标</translation>
    </message>
    <message>
        <source>When the next goal is sent</source>
        <translation>何时发送下一个目标</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>停留</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>延时</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>循环次数</translation>
    </message>
    <message>
        <source>One cycle goes to the end and back</source>
        <translation>一个循环为一去一回</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Travel time</source>
        <translation>运行时间</translation>
    </message>
    <message>
        <source>Warm-up</source>
        <translation>预热</translation>
    </message>
    <message>
        <source>After the test</source>
        <translation>测试结束后</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作员</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> 毫秒</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分钟</translation>
    </message>
    <message>
        <source>set by speed</source>
        <translation>由速度决定</translation>
    </message>
    <message>
        <source>After a delay</source>
        <translation>延时之后</translation>
    </message>
    <message>
        <source>After arrival</source>
        <translation>到达之后</translation>
    </message>
    <message>
        <source>A number of cycles</source>
        <translation>循环次数</translation>
    </message>
    <message>
        <source>Hold position</source>
        <translation>保持位置</translation>
    </message>
    <message>
        <source>Torque off</source>
        <translation>卸力</translation>
    </message>
    <message>
        <source>Back and forth between start and end</source>
        <translation>在起始位置与结束位置之间往返</translation>
    </message>
    <message>
        <source>Staircase</source>
        <translation>阶梯</translation>
    </message>
    <message>
        <source>From start to end in steps, and back in the same steps</source>
        <translation>从起始位置逐步走到结束位置，再逐步返回</translation>
    </message>
    <message>
        <source>Both directions</source>
        <translation>双向</translation>
    </message>
    <message>
        <source>Approaches the middle of the range from both directions; shows hysteresis</source>
        <translation>从两个方向到达行程范围的中间；可查看回差</translation>
    </message>
    <message>
        <source>The goal follows a sine wave: shows how well the servo follows</source>
        <translation>目标按正弦变化：可查看跟随性能</translation>
    </message>
    <message>
        <source>Random goals; the same seed gives the same goals</source>
        <translation>随机目标，种子相同则目标相同</translation>
    </message>
    <message>
        <source>Goals from a file, one per line</source>
        <translation>目标取自文件，每行一个</translation>
    </message>
    <message>
        <source>A raw value, or an angle with its unit, such as 90deg</source>
        <translation>原始值，或带单位的角度，如 90deg</translation>
    </message>
    <message>
        <source>A number of steps, or an angle with its unit, such as 10deg</source>
        <translation>原始步数，或带单位的角度，如 10deg</translation>
    </message>
    <message>
        <source>Duration of one full sine period, to the end and back</source>
        <translation>一个完整正弦周期的时间，到结束位置再返回</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>The same seed gives the same goals</source>
        <translation>种子相同则目标相同</translation>
    </message>
    <message>
        <source>Goals</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>A text file: one goal per line, optionally followed by a comma and a pause in milliseconds</source>
        <translation>文本文件：每行一个目标，后面可加逗号和停顿时间（毫秒）</translation>
    </message>
    <message>
        <source>Pause after the goal is reached</source>
        <translation>到达目标后停留的时间</translation>
    </message>
    <message>
        <source>Time from one goal to the next, whether or not the goal is reached</source>
        <translation>从一个目标到下一个目标的时间，不论是否到达目标</translation>
    </message>
    <message>
        <source>End after</source>
        <translation>结束条件</translation>
    </message>
    <message>
        <source>Condition that ends the test</source>
        <translation>满足此条件时测试结束</translation>
    </message>
    <message>
        <source>Counted from the first move</source>
        <translation>从第一个行程算起</translation>
    </message>
    <message>
        <source>Raw value, or a value with its unit, such as 30rpm; leave empty to use the present setting</source>
        <translation>原始值，或带单位的值，如 30rpm；留空则使用舵机的现有设置</translation>
    </message>
    <message>
        <source>Raw value; leave empty to use the present setting</source>
        <translation>原始值；留空则使用舵机的现有设置</translation>
    </message>
    <message>
        <source>Travel time of a move in milliseconds; leave empty to let the speed determine it</source>
        <translation>一个行程的运行时间（毫秒）；留空则由速度决定</translation>
    </message>
    <message>
        <source>How long the servo moves before measuring starts</source>
        <translation>开始测量前舵机先运动的时长</translation>
    </message>
    <message>
        <source>State of the servos after the test ends or is stopped</source>
        <translation>测试结束或停止后舵机的状态</translation>
    </message>
    <message>
        <source>Appears in the report</source>
        <translation>此内容会记入报告</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>不改变</translation>
    </message>
    <message>
        <source>A set time</source>
        <translation>时长</translation>
    </message>
</context>
<context>
    <name>ui::SweepGoalList</name>
    <message>
        <source>Open a list of goals</source>
        <translation>打开目标列表</translation>
    </message>
    <message>
        <source>Goal lists (*.csv *.txt)</source>
        <translation>目标列表 (*.csv *.txt)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Open a list…</source>
        <translation>打开列表…</translation>
    </message>
    <message numerus="yes">
        <source>%1 (%n goal(s))</source>
        <translation>
            <numerusform>%1（%n 个目标）</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::SweepLeftoversBanner</name>
    <message>
        <source>The test could not be saved to the history.</source>
        <translation>测试未能存入历史记录。</translation>
    </message>
    <message>
        <source>The test was saved to the file %1.</source>
        <translation>测试已保存到文件 %1。</translation>
    </message>
    <message>
        <source>%1 (old value %2)</source>
        <translation>%1（原值 %2）</translation>
    </message>
    <message>
        <source>Test settings are still in effect: %1.</source>
        <translation>测试用的设置仍然有效：%1。</translation>
    </message>
</context>
<context>
    <name>ui::SweepLegsModel</name>
    <message>
        <source>The last %1 of %2 moves are shown; the CSV and JSON files contain all moves.</source>
        <translation>仅显示最近 %1 个行程（共 %2 个）；CSV 和 JSON 文件含全部行程。</translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s) lost</source>
        <translation>
            <numerusform>丢失 %n 个采样数据</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::SweepPage</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 小时 %2 分钟</translation>
    </message>
    <message>
        <source>cycle %1 of %2</source>
        <translation>第 %1 个循环，共 %2 个</translation>
    </message>
    <message>
        <source>cycle %1</source>
        <translation>第 %1 个循环</translation>
    </message>
    <message>
        <source>%1 · %2 left</source>
        <translation>%1 · 剩余 %2</translation>
    </message>
    <message>
        <source>Start the test?</source>
        <translation>开始测试？</translation>
    </message>
    <message>
        <source>Torque is turned on, and these servos move by themselves until the test has ended: %1</source>
        <translation>以下舵机将打开扭矩并自行运动，直到测试结束：%1</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Sweep test</source>
        <translation>扫描测试</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Switch to position mode for the test</source>
        <translation>测试期间切换到位置模式</translation>
    </message>
    <message>
        <source>Progress of the test</source>
        <translation>测试进度</translation>
    </message>
    <message>
        <source>The test has ended; stopping the servos</source>
        <translation>测试已结束，正在停止舵机</translation>
    </message>
    <message>
        <source>range %1 … %2</source>
        <translation>范围 %1～%2</translation>
    </message>
    <message>
        <source>The test was not started.</source>
        <translation>测试没有开始。</translation>
    </message>
    <message>
        <source>Torque could not be turned off: %1.</source>
        <translation>未能卸力：%1。</translation>
    </message>
    <message>
        <source>Movement could not be stopped: %1.</source>
        <translation>未能停止运动：%1。</translation>
    </message>
    <message>
        <source>These servos may still be holding their position or moving to their last goal. Press the emergency stop or disconnect the power supply.</source>
        <translation>这些舵机可能仍在保持位置，或仍在向最后的目标位置运动。请按急停，或切断供电。</translation>
    </message>
    <message>
        <source>The servo to be tested is no longer in the list or was replaced.</source>
        <translation>要测试的舵机已不在列表中，或已被更换。</translation>
    </message>
    <message>
        <source>Select the servo and start again.</source>
        <translation>请选择舵机后重新开始。</translation>
    </message>
    <message>
        <source>Connect first: no port is open.</source>
        <translation>请先连接：尚未打开端口。</translation>
    </message>
    <message>
        <source>A search is running; the test can start when the search has ended.</source>
        <translation>正在搜索；搜索结束后才能开始测试。</translation>
    </message>
    <message>
        <source>Select a servo in the list, or select one below.</source>
        <translation>请在列表中选择舵机，或在下方勾选。</translation>
    </message>
    <message>
        <source>Starts the test: the servos will move</source>
        <translation>开始测试：舵机将会运动</translation>
    </message>
    <message>
        <source>Ends the test; the servos hold their position, or torque is turned off, as selected under &quot;After the test&quot;</source>
        <translation>结束测试；舵机按“测试结束后”的选择保持位置或卸力</translation>
    </message>
    <message>
        <source>Switches back after the test; nothing is stored permanently in the servo</source>
        <translation>测试结束后切换回原模式；舵机中不会永久保存任何改动</translation>
    </message>
    <message>
        <source>Keep hands and objects away from the servos. Esc immediately turns torque off on all servos.</source>
        <translation>请让双手和物体远离舵机的运动范围。按 Esc 立即让所有舵机卸力。</translation>
    </message>
    <message>
        <source>goals from the list</source>
        <translation>列表中的目标</translation>
    </message>
    <message>
        <source>Afterwards, torque is off, even if you stop the test or close the window.</source>
        <translation>结束后舵机卸力。中途停止测试或关闭窗口也是如此。</translation>
    </message>
    <message>
        <source>Afterwards, the servos hold their position with torque on, even if you stop the test or close the window.</source>
        <translation>结束后舵机保持位置，扭矩保持打开。中途停止测试或关闭窗口也是如此。</translation>
    </message>
    <message>
        <source>Afterwards, torque is off on servos that switch back to another mode.</source>
        <translation>如果舵机测试后切回其他模式，则保持卸力。</translation>
    </message>
    <message>
        <source>Moving to the start</source>
        <translation>正在前往起始位置</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>改为 %1</translation>
    </message>
    <message>
        <source>the sine wave is faster than the servo can move. Use a period of at least %1.</source>
        <translation>此正弦所需的速度超过舵机的最高速度，周期至少需要 %1。</translation>
    </message>
    <message>
        <source>the longest move takes %1 at this speed, so the servo would turn back before it arrives.</source>
        <translation>按此速度，最长行程需要 %1；延时太短，舵机未到达就会折返。</translation>
    </message>
    <message>
        <source>most moves are too short for a verdict; a goal counts as reached within %1 steps, so each move must be at least %2 steps long.</source>
        <translation>大多数行程太短，无法得出结论；距目标 %1 步以内即视为到位，因此每个行程至少需要 %2 步。</translation>
    </message>
    <message>
        <source>the speed is unknown, so the delay cannot be checked.</source>
        <translation>速度未知，无法判断延时是否够用。</translation>
    </message>
    <message>
        <source>the longest move takes %1 at this speed.</source>
        <translation>按此速度，最长行程需要 %1。</translation>
    </message>
    <message>
        <source>the longest move takes %1 at this speed; the delay is long enough.</source>
        <translation>按此速度，最长行程需要 %1，延时够用。</translation>
    </message>
    <message>
        <source>About %1 in total.</source>
        <translation>全程约 %1。</translation>
    </message>
    <message>
        <source>No reply from %1 for %2</source>
        <translation>%1 无应答，已持续 %2</translation>
    </message>
    <message>
        <source>Warming up; not measuring yet</source>
        <translation>预热中，尚未开始测量</translation>
    </message>
    <message>
        <source>Movement is blocked by the emergency stop, and torque is off: %1. Click Allow movement to turn torque on; nothing moves until you click Run.</source>
        <translation>急停后已卸力，禁止运动：%1。点击“允许运动”可打开扭矩；点击“运行”之前，舵机不会运动。</translation>
    </message>
    <message>
        <source>ID %1: </source>
        <translation>ID %1：</translation>
    </message>
</context>
<context>
    <name>ui::SweepResults</name>
    <message>
        <source>Position and goal</source>
        <translation>位置与目标</translation>
    </message>
    <message>
        <source>Position and goal — %1</source>
        <translation>位置与目标 — %1</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>Metrics and their grades</source>
        <translation>各项指标与判定</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>行程</translation>
    </message>
    <message>
        <source>All metrics</source>
        <translation>全部指标</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Earlier tests…</source>
        <translation>以往测试…</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>no reply</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>No test has been run yet. Select a test on the left, check the start and end positions, then click Run; the servo will move.</source>
        <translation>尚未运行测试。请在左侧选择测试，确认起始和结束位置，然后点击“运行”；舵机将会运动。</translation>
    </message>
    <message>
        <source>Hover over a row for details</source>
        <translation>将鼠标悬停在某一行上可查看详情</translation>
    </message>
    <message>
        <source>Also shows metrics that have no limit</source>
        <translation>也显示没有限值的指标</translation>
    </message>
    <message>
        <source>Error at the goal</source>
        <translation>到位误差</translation>
    </message>
    <message>
        <source>Saves all moves as a table and all readings in a second file in the same folder</source>
        <translation>将全部行程保存为表格，并在同一文件夹中另存全部采样数据</translation>
    </message>
    <message>
        <source>Saves the report as %1 and all readings in a second file in the same folder</source>
        <translation>将报告保存为 %1，并在同一文件夹中另存全部采样数据</translation>
    </message>
    <message>
        <source>Lists saved tests; you can compare two or select a reference</source>
        <translation>列出已保存的测试；可对比两次测试，或选定参考舵机</translation>
    </message>
    <message numerus="yes">
        <source>The test was paused by %n bus interruption(s).</source>
        <translation>
            <numerusform>测试期间总线中断 %n 次，每次恢复后测试继续。</numerusform>
        </translation>
    </message>
    <message>
        <source>RUNNING</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>%1 (ID %2)</source>
        <translation>%1（ID %2）</translation>
    </message>
</context>
<context>
    <name>ui::SweepServos</name>
    <message>
        <source>Limits: %1</source>
        <translation>限值：%1</translation>
    </message>
    <message>
        <source>Servos</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>Limits…</source>
        <translation>限值…</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>End</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Select the servo to include it in the test</source>
        <translation>勾选的舵机参加测试</translation>
    </message>
    <message>
        <source>Range of this servo; leave empty to use the start and end above</source>
        <translation>此舵机的范围；留空：使用上面的起始和结束位置</translation>
    </message>
    <message>
        <source>Limits: built-in</source>
        <translation>限值：内置</translation>
    </message>
    <message>
        <source>Servos to test</source>
        <translation>要测试的舵机</translation>
    </message>
    <message>
        <source>Select the servos to test; enter individual start and end values where needed</source>
        <translation>勾选参加测试的舵机；需要时可单独填写起始和结束位置</translation>
    </message>
    <message>
        <source>Shows, edits, loads and saves the limits for the servo in the selected row</source>
        <translation>查看、编辑、载入和保存所选行中舵机的限值</translation>
    </message>
</context>
<context>
    <name>ui::SweepVerdictModel</name>
    <message>
        <source>no limit</source>
        <translation>未设限值</translation>
    </message>
</context>
<context>
    <name>ui::TemplateDialog</name>
    <message>
        <source>Rows of the template</source>
        <translation>模板包含的行</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>含义</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message numerus="yes">
        <source>Save %n row(s)…</source>
        <translation>
            <numerusform>保存 %n 行…</numerusform>
        </translation>
    </message>
    <message>
        <source>Create a template</source>
        <translation>制作模板</translation>
    </message>
    <message>
        <source>Select the rows to write to other servos. ID and baud rate are never part of a template. Rows that differ from the factory defaults are preselected.</source>
        <translation>勾选要写入其他舵机的行。模板不包含 ID 和波特率。与出厂默认值不同的行已预先勾选。</translation>
    </message>
    <message>
        <source>Saves the selected rows to a file</source>
        <translation>把勾选的行保存为文件</translation>
    </message>
    <message>
        <source>Closes without saving</source>
        <translation>关闭对话框，不保存</translation>
    </message>
</context>
<context>
    <name>ui::TorqueHint</name>
    <message>
        <source>Do not show this again</source>
        <translation>不再显示此提示</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Check before turning torque on for the first time in this session</source>
        <translation>本次启动程序后首次打开扭矩前，请检查</translation>
    </message>
    <message>
        <source>• The bracket and horn cannot catch or jam
• Fingers and cables are away from the shaft
• The polarity and voltage of the power supply are correct
• Above 12 V, the power wires are thick enough</source>
        <translation>• 支架和舵盘不会钩住或卡住
• 手指和线缆远离输出轴
• 电源的极性和电压正确
• 电压高于 12 V 时，电源线足够粗</translation>
    </message>
    <message>
        <source>Applies to later sessions too</source>
        <translation>以后启动程序时也不再显示此提示</translation>
    </message>
    <message>
        <source>Leaves the servo as it is</source>
        <translation>保持舵机现状</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>已检查，继续</translation>
    </message>
    <message>
        <source>Performs the requested action; this reminder does not appear again until the program is restarted</source>
        <translation>继续执行操作；重新启动程序之前不再提示</translation>
    </message>
</context>
<context>
    <name>ui::TrendChart</name>
    <message>
        <source>Trend chart</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>Whole recording</source>
        <translation>整段录制</translation>
    </message>
    <message>
        <source>All channels are hidden</source>
        <translation>所有通道均已隐藏</translation>
    </message>
    <message>
        <source>No file name specified.</source>
        <translation>未指定文件名。</translation>
    </message>
    <message>
        <source>%1 could not be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
    <message>
        <source>All recorded data; drag the frame to show another part, or drag its edges to show more or less.</source>
        <translation>全部录制数据；拖动方框可查看其他部分，拖动方框边缘可扩大或缩小显示范围。</translation>
    </message>
    <message>
        <source>No channels selected</source>
        <translation>未选择通道</translation>
    </message>
    <message>
        <source>Drag: pan. Wheel: zoom time. Shift+wheel: zoom values. Ctrl+drag: zoom into a box. Double-click: show all. Backspace: previous view. Space: pause.</source>
        <translation>拖动：平移。滚轮：缩放时间。Shift+滚轮：缩放数值。Ctrl+拖动：框选放大。双击：显示全部。Backspace：上一视图。空格：暂停。</translation>
    </message>
    <message>
        <source>Drag up or down to move this lane</source>
        <translation>上下拖动可移动该栏</translation>
    </message>
</context>
<context>
    <name>ui::TrendPanel</name>
    <message>
        <source>Save view</source>
        <translation>保存视图</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>名称：</translation>
    </message>
</context>
<context>
    <name>ui::TrendReplay</name>
    <message>
        <source>Open a recording</source>
        <translation>打开录制文件</translation>
    </message>
    <message>
        <source>Recordings (*.csv *.jsonl)</source>
        <translation>录制文件 (*.csv *.jsonl)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message numerus="yes">
        <source>Recording %1: %Ln row(s)</source>
        <translation>
            <numerusform>录制文件 %1：%Ln 行</numerusform>
        </translation>
    </message>
    <message>
        <source>The last line is incomplete and is not shown.</source>
        <translation>最后一行不完整，未显示。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln line(s) could not be read</source>
        <translation>
            <numerusform>%Ln 行无法读取</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::TrendToolbar</name>
    <message>
        <source>Stop recording</source>
        <translation>停止录制</translation>
    </message>
    <message>
        <source>Record…</source>
        <translation>录制…</translation>
    </message>
    <message>
        <source>&amp;Open a recording…</source>
        <translation>打开录制文件(&amp;O)…</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>游标</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>正在录制</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>显示时长</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 小时</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>&amp;Clear chart data</source>
        <translation>清除曲线数据(&amp;C)</translation>
    </message>
    <message>
        <source>Save &amp;view as…</source>
        <translation>视图另存为(&amp;V)…</translation>
    </message>
    <message>
        <source>&amp;Delete view</source>
        <translation>删除视图(&amp;D)</translation>
    </message>
    <message>
        <source>Pauses the chart; measuring continues (Space)</source>
        <translation>暂停曲线；测量不中断（空格键）</translation>
    </message>
    <message>
        <source>Shows all measured data</source>
        <translation>显示全部测量数据</translation>
    </message>
    <message>
        <source>Measures between two cursors</source>
        <translation>在两个游标之间测量</translation>
    </message>
    <message>
        <source>Channels…</source>
        <translation>通道…</translation>
    </message>
    <message>
        <source>Selects the servos and registers to show</source>
        <translation>选择显示哪些舵机的哪些参数</translation>
    </message>
    <message>
        <source>Pauses the chart when an event occurs</source>
        <translation>事件发生时暂停曲线</translation>
    </message>
    <message>
        <source>Back to live data</source>
        <translation>返回实时数据</translation>
    </message>
    <message>
        <source>Closes the recording and shows live values</source>
        <translation>关闭录制文件，显示实时数据</translation>
    </message>
    <message>
        <source>Records measured values to a file</source>
        <translation>把测量值录制到文件</translation>
    </message>
    <message>
        <source>Length of time shown in the chart</source>
        <translation>曲线图显示的时间长度</translation>
    </message>
    <message>
        <source>&amp;Previous view</source>
        <translation>上一视图(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Readings per second</source>
        <translation>每秒读取次数(&amp;R)</translation>
    </message>
    <message>
        <source>As fast as the bus allows</source>
        <translation>总线允许的最快速度</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>显示全部(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Trigger…</source>
        <translation>触发(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Export view…</source>
        <translation>导出视图(&amp;E)…</translation>
    </message>
    <message>
        <source>Lanes</source>
        <translation>分栏</translation>
    </message>
    <message>
        <source>Shows each quantity in its own lane</source>
        <translation>每种物理量各占一栏</translation>
    </message>
    <message>
        <source>Trigger, read rate, export, recordings and saved views</source>
        <translation>触发、读取频率、导出、录制文件和已保存的视图</translation>
    </message>
    <message>
        <source>Stops waiting for the event</source>
        <translation>停止等待该事件</translation>
    </message>
    <message>
        <source>Ends the recording and closes its file</source>
        <translation>结束录制并关闭文件</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>触发</translation>
    </message>
    <message>
        <source>&amp;Memory for readings</source>
        <translation>采样数据可用内存(&amp;M)</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
</context>
<context>
    <name>ui::TriggerControl</name>
    <message>
        <source>Stop waiting</source>
        <translation>停止等待</translation>
    </message>
    <message>
        <source>Triggered…</source>
        <translation>已触发…</translation>
    </message>
</context>
<context>
    <name>ui::TriggerDialog</name>
    <message>
        <source>Trigger</source>
        <translation>触发</translation>
    </message>
    <message>
        <source>The value rises through a level</source>
        <translation>数值上升越过阈值</translation>
    </message>
    <message>
        <source>The value falls through a level</source>
        <translation>数值下降越过阈值</translation>
    </message>
    <message>
        <source>The value is above a level</source>
        <translation>数值高于阈值</translation>
    </message>
    <message>
        <source>The value is below a level</source>
        <translation>数值低于阈值</translation>
    </message>
    <message>
        <source>The servo has stopped</source>
        <translation>舵机停止运动</translation>
    </message>
    <message>
        <source>An alarm occurs</source>
        <translation>出现报警</translation>
    </message>
    <message>
        <source>A servo stops replying</source>
        <translation>舵机停止应答</translation>
    </message>
    <message>
        <source>Wait until</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>Hysteresis</source>
        <translation>迟滞</translation>
    </message>
    <message>
        <source>Seconds before</source>
        <translation>触发前秒数</translation>
    </message>
    <message>
        <source>Seconds after</source>
        <translation>触发后秒数</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Pauses the chart when the event occurs</source>
        <translation>事件发生时暂停曲线</translation>
    </message>
    <message>
        <source>No values suitable for a trigger are being read</source>
        <translation>当前未读取任何可用于触发的数据</translation>
    </message>
    <message>
        <source>The servo starts to move</source>
        <translation>舵机开始运动</translation>
    </message>
    <message>
        <source>A value is written</source>
        <translation>有写入操作</translation>
    </message>
    <message>
        <source>Event that the chart waits for</source>
        <translation>曲线图要等待的事件</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Channel to monitor</source>
        <translation>要监视的通道</translation>
    </message>
    <message>
        <source>In the unit of the channel</source>
        <translation>单位与通道相同</translation>
    </message>
    <message>
        <source>How far the value must first move to the other side of the level; prevents repeated triggering by noise</source>
        <translation>数值须先到阈值另一侧并超出此幅度，才能触发；避免噪声造成重复触发</translation>
    </message>
    <message>
        <source>Time shown before the trigger</source>
        <translation>显示触发前多长时间的数据</translation>
    </message>
    <message>
        <source>Time shown after the trigger; then the chart pauses</source>
        <translation>显示触发后多长时间的数据；之后曲线暂停</translation>
    </message>
    <message>
        <source>Wait for trigger</source>
        <translation>等待触发</translation>
    </message>
    <message>
        <source>Closes without setting a trigger</source>
        <translation>关闭对话框，不设置触发</translation>
    </message>
</context>
<context>
    <name>ui::Welcome</name>
    <message>
        <source>No servos connected yet</source>
        <translation>尚未连接舵机</translation>
    </message>
    <message>
        <source>Try a simulated bus</source>
        <translation>试用模拟总线</translation>
    </message>
    <message>
        <source>Simulated servos; nothing needs to be connected</source>
        <translation>模拟舵机，无需连接任何硬件</translation>
    </message>
    <message>
        <source>Plug in the adapter, turn on the servos&apos; power supply, and select the port above. Connecting and searching do not write anything or move any servo.</source>
        <translation>插入适配器，打开舵机电源，在上方选择端口。连接和搜索不会写入任何内容，舵机也不会转动。</translation>
    </message>
    <message>
        <source>Connect to selected port</source>
        <translation>连接所选端口</translation>
    </message>
    <message>
        <source>Opens the port selected above and searches it for servos</source>
        <translation>打开上方所选端口并搜索舵机</translation>
    </message>
    <message>
        <source>No hardware? The simulated bus has servos of several families, some with faults to find.</source>
        <translation>手边没有硬件？模拟总线上有多个系列的舵机，其中一些带有可供排查的故障。</translation>
    </message>
    <message>
        <source>Find servos on all ports…</source>
        <translation>在所有端口上查找舵机…</translation>
    </message>
    <message>
        <source>Try a simulated robot arm</source>
        <translation>试用模拟机械臂</translation>
    </message>
</context>
</TS>
