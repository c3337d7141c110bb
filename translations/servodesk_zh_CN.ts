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
        <source>Leave everything as it is</source>
        <translation>保持原样，不做任何修改</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>&amp;Connect</source>
        <translation>连接(&amp;C)</translation>
    </message>
    <message>
        <source>Open the chosen port and search it</source>
        <translation>打开所选端口并搜索舵机</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>断开(&amp;D)</translation>
    </message>
    <message>
        <source>Close the port; a running write ends first</source>
        <translation>关闭端口；正在进行的写入会先完成</translation>
    </message>
    <message>
        <source>Use the &amp;simulated bus</source>
        <translation>使用模拟总线(&amp;S)</translation>
    </message>
    <message>
        <source>Try everything on simulated servos, without hardware</source>
        <translation>无需硬件，用模拟舵机试用全部功能</translation>
    </message>
    <message>
        <source>S&amp;witch the simulated servos off and on</source>
        <translation>模拟舵机断电再上电(&amp;W)</translation>
    </message>
    <message>
        <source>What was written temporarily is lost, as at a real power-off</source>
        <translation>临时写入的值会丢失，与真实断电一样</translation>
    </message>
    <message>
        <source>&amp;Search</source>
        <translation>搜索(&amp;S)</translation>
    </message>
    <message>
        <source>Search the bus for servos; writes nothing</source>
        <translation>搜索总线上的舵机；不写入任何内容</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>停止(&amp;T)</translation>
    </message>
    <message>
        <source>End the search; what was found stays</source>
        <translation>结束搜索；已找到的舵机保留</translation>
    </message>
    <message>
        <source>Stop the running &amp;task</source>
        <translation>停止当前任务(&amp;T)</translation>
    </message>
    <message>
        <source>End what is being done to a servo; a write in progress ends safely first</source>
        <translation>结束对舵机的操作；正在进行的写入会先安全完成</translation>
    </message>
    <message>
        <source>&amp;Read all</source>
        <translation>读取全部(&amp;R)</translation>
    </message>
    <message>
        <source>Read the whole memory table of the selected servo; writes nothing</source>
        <translation>读取所选舵机的整个内存表；不写入任何内容</translation>
    </message>
    <message>
        <source>&amp;Find a register</source>
        <translation>查找参数(&amp;F)</translation>
    </message>
    <message>
        <source>Go to the field that filters the memory table</source>
        <translation>转到内存表的筛选框</translation>
    </message>
    <message>
        <source>Close the EPROM &amp;lock</source>
        <translation>EPROM 上锁(&amp;L)</translation>
    </message>
    <message>
        <source>Close the lock that stands open, so that nothing is changed for good by accident</source>
        <translation>给未上锁的 EPROM 上锁，以免误改并永久保存</translation>
    </message>
    <message>
        <source>&amp;Copy rows</source>
        <translation>复制行(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the selected rows of the table as text</source>
        <translation>以文本形式复制表中选中的行</translation>
    </message>
    <message>
        <source>&amp;Export the table…</source>
        <translation>导出内存表(&amp;E)…</translation>
    </message>
    <message>
        <source>Write the memory table to a CSV or HTML file</source>
        <translation>把内存表写入 CSV 或 HTML 文件</translation>
    </message>
    <message>
        <source>&amp;Print the table…</source>
        <translation>打印内存表(&amp;P)…</translation>
    </message>
    <message>
        <source>Print the memory table</source>
        <translation>打印内存表</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Write the old values of the last change back</source>
        <translation>写回上一次更改之前的值</translation>
    </message>
    <message>
        <source>Re&amp;do</source>
        <translation>重做(&amp;D)</translation>
    </message>
    <message>
        <source>Write the change again that was undone</source>
        <translation>重新写入被撤销的更改</translation>
    </message>
    <message>
        <source>Set &amp;ID…</source>
        <translation>设置 ID(&amp;I)…</translation>
    </message>
    <message>
        <source>Give the servo another ID, which is proven free first</source>
        <translation>更改舵机 ID；先确认新 ID 未被占用</translation>
    </message>
    <message>
        <source>Set &amp;baud rate…</source>
        <translation>设置波特率(&amp;B)…</translation>
    </message>
    <message>
        <source>Give the servo another baud rate, and follow it there</source>
        <translation>更改舵机波特率，并以新波特率继续通信</translation>
    </message>
    <message>
        <source>&amp;Centre here…</source>
        <translation>当前位置校中(&amp;C)…</translation>
    </message>
    <message>
        <source>Make the present position the middle</source>
        <translation>把当前位置设为中位</translation>
    </message>
    <message>
        <source>Restore &amp;defaults…</source>
        <translation>恢复出厂设置(&amp;D)…</translation>
    </message>
    <message>
        <source>Back to factory settings; the table is saved first</source>
        <translation>恢复出厂设置；先保存内存表</translation>
    </message>
    <message>
        <source>&amp;Restart…</source>
        <translation>重启舵机(&amp;R)…</translation>
    </message>
    <message>
        <source>Take torque off, restart the servo and wait for it</source>
        <translation>卸力后重启舵机并等待其恢复</translation>
    </message>
    <message>
        <source>Identi&amp;fy</source>
        <translation>识别舵机(&amp;F)</translation>
    </message>
    <message>
        <source>Let the servo show its LED for some seconds</source>
        <translation>让舵机的 LED 亮几秒</translation>
    </message>
    <message>
        <source>Clear &amp;alarm…</source>
        <translation>解除报警(&amp;A)…</translation>
    </message>
    <message>
        <source>Show what holds the alarm and release it by its cause</source>
        <translation>显示报警原因，并按原因解除</translation>
    </message>
    <message>
        <source>Interrupted &amp;writes…</source>
        <translation>中断的写入(&amp;W)…</translation>
    </message>
    <message>
        <source>Writes of earlier sessions that have no end in the journal</source>
        <translation>以前未完成的写入（记录中没有结束）</translation>
    </message>
    <message>
        <source>&amp;Torque off — all</source>
        <translation>全部卸力(&amp;T)</translation>
    </message>
    <message>
        <source>Theme of the &amp;system</source>
        <translation>跟随系统(&amp;S)</translation>
    </message>
    <message>
        <source>Light or dark as the desktop is</source>
        <translation>浅色或深色，与桌面一致</translation>
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
        <source>The interface in English</source>
        <translation>英文界面</translation>
    </message>
    <message>
        <source>The interface in Simplified Chinese</source>
        <translation>简体中文界面</translation>
    </message>
    <message>
        <source>&amp;Messages</source>
        <translation>消息(&amp;M)</translation>
    </message>
    <message>
        <source>Everything that was reported since the start</source>
        <translation>启动以来的全部消息</translation>
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
        <source>The list of all shortcuts</source>
        <translation>全部快捷键列表</translation>
    </message>
    <message>
        <source>&amp;About ServoDesk</source>
        <translation>关于 ServoDesk(&amp;A)</translation>
    </message>
    <message>
        <source>Version, licence and where files are kept</source>
        <translation>版本、许可证和文件存放位置</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>End the program; a running write ends first</source>
        <translation>退出程序；正在进行的写入会先完成</translation>
    </message>
    <message>
        <source>&amp;Operate</source>
        <translation>操作(&amp;O)</translation>
    </message>
    <message>
        <source>Drive the servo and watch it</source>
        <translation>驱动舵机并观察</translation>
    </message>
    <message>
        <source>&amp;Memory table</source>
        <translation>内存表(&amp;M)</translation>
    </message>
    <message>
        <source>Read and change what the servo keeps</source>
        <translation>读取和修改舵机保存的参数</translation>
    </message>
    <message>
        <source>&amp;Pause the chart</source>
        <translation>暂停曲线(&amp;P)</translation>
    </message>
    <message>
        <source>Let the chart stand still, or follow again; measuring goes on</source>
        <translation>让曲线静止或继续跟随；测量不中断</translation>
    </message>
    <message>
        <source>&amp;Record…</source>
        <translation>记录(&amp;R)…</translation>
    </message>
    <message>
        <source>Write what is measured to a file, or end that</source>
        <translation>把测量值写入文件，或结束记录</translation>
    </message>
    <message>
        <source>Op&amp;en a recording…</source>
        <translation>打开记录(&amp;E)…</translation>
    </message>
    <message>
        <source>Show a recording in the chart</source>
        <translation>在曲线图中显示记录</translation>
    </message>
    <message>
        <source>S&amp;weep test</source>
        <translation>扫描测试(&amp;W)</translation>
    </message>
    <message>
        <source>Run servos through their paces and judge them</source>
        <translation>让舵机走一遍测试并判定好坏</translation>
    </message>
    <message>
        <source>S&amp;tep response</source>
        <translation>阶跃响应(&amp;T)</translation>
    </message>
    <message>
        <source>See how a servo answers a step, and try other gains</source>
        <translation>查看舵机对阶跃的响应，并试用其他增益</translation>
    </message>
    <message>
        <source>&amp;Earlier tests…</source>
        <translation>以往测试(&amp;E)…</translation>
    </message>
    <message>
        <source>Look at kept tests, compare two, choose a reference</source>
        <translation>查看已保存的测试，比较两次测试，选定参考舵机</translation>
    </message>
    <message>
        <source>S&amp;napshots</source>
        <translation>快照(&amp;N)</translation>
    </message>
    <message>
        <source>Save, compare and restore what servos keep</source>
        <translation>保存、比较和恢复舵机里的设置</translation>
    </message>
    <message>
        <source>Take s&amp;napshot</source>
        <translation>保存快照(&amp;N)</translation>
    </message>
    <message>
        <source>Read the whole table and keep it in the history</source>
        <translation>读取整个内存表并存入历史记录</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>历史记录(&amp;H)</translation>
    </message>
    <message>
        <source>What was ever written, saved, tested and alarmed</source>
        <translation>所有写入、快照、测试和报警的记录</translation>
    </message>
    <message>
        <source>&amp;Commissioning</source>
        <translation>批量设置(&amp;C)</translation>
    </message>
    <message>
        <source>Set up servos plugged in one after the other</source>
        <translation>逐个接上并设置舵机</translation>
    </message>
    <message>
        <source>Take torque off the whole bus at once (Esc, also in a field of the motion panel; whatever is open: Shift+Esc)</source>
        <translation>立即让整条总线卸力（Esc，在运动面板的输入框中也有效；无论打开什么：Shift+Esc）</translation>
    </message>
</context>
<context>
    <name>ControlWords</name>
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
        <source>counter-clockwise</source>
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
        <source>Speed 0 = the time counts</source>
        <translation>速度 0 = 按时间运行</translation>
    </message>
    <message>
        <source>no faster than %1 (%2): the model&apos;s maximum</source>
        <translation>不会快于 %1（%2）：此型号的最大值</translation>
    </message>
    <message>
        <source>model&apos;s maximum %1 (%2)</source>
        <translation>型号最大值 %1（%2）</translation>
    </message>
    <message>
        <source>Goes to an angle inside its limits</source>
        <translation>转到限位内的角度</translation>
    </message>
    <message>
        <source>Goes to an angle up to 7.5 turns either way; turns are counted from power-on</source>
        <translation>可转到正反各 7.5 圈内的角度；圈数从上电开始计</translation>
    </message>
    <message>
        <source>Turns on and on at a speed that is held under load</source>
        <translation>持续转动，带载时保持速度</translation>
    </message>
    <message>
        <source>Turns on and on; the speed falls under load</source>
        <translation>持续转动；带载时速度下降</translation>
    </message>
    <message>
        <source>Each goal is a step from where it is, 7.5 turns in all</source>
        <translation>每个目标都是从当前位置走一步，总共 7.5 圈</translation>
    </message>
    <message>
        <source>Turns on and on like a motor</source>
        <translation>像电机一样持续转动</translation>
    </message>
    <message>
        <source>Pushes with a current, that is a torque</source>
        <translation>按电流（即扭矩）输出</translation>
    </message>
    <message>
        <source>Position without integral part, of newer firmware; one turn only</source>
        <translation>新固件的位置 PD 模式，无积分；仅限一圈</translation>
    </message>
    <message>
        <source>Goes to an angle and lets go there</source>
        <translation>转到角度后卸力</translation>
    </message>
    <message>
        <source>The angle limits %1 are remembered for the way back.</source>
        <translation>角度限制 %1 已记住，切换回来时恢复。</translation>
    </message>
    <message>
        <source>The angle limits %1 from before come back.</source>
        <translation>恢复之前的角度限制 %1。</translation>
    </message>
    <message>
        <source>No angle limits are remembered for this servo: it gets those of the factory, %1.</source>
        <translation>没有记住此舵机的角度限制：使用出厂值 %1。</translation>
    </message>
    <message>
        <source>Torque goes off first and stays off until you switch it on.</source>
        <translation>先关闭扭矩，并保持关闭直到您打开。</translation>
    </message>
    <message>
        <source>Torque is off and stays off.</source>
        <translation>扭矩已关闭并保持关闭。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; becomes 0, so that nothing starts by itself.</source>
        <translation>“%1”置 0，避免自行启动。</translation>
    </message>
    <message>
        <source>Everything is read back; the mode stays after power-off.</source>
        <translation>全部读回核对；断电后模式保持不变。</translation>
    </message>
    <message>
        <source>The other chosen servos are switched the same way: %1</source>
        <translation>其他选中的舵机同样切换：%1</translation>
    </message>
    <message>
        <source>0 = the strongest</source>
        <translation>0 = 最大</translation>
    </message>
</context>
<context>
    <name>EventWords</name>
    <message>
        <source>%1 %2 → %3, %4</source>
        <translation>%1 %2 → %3，%4</translation>
    </message>
    <message>
        <source>ID %1 · %2</source>
        <translation>ID %1 · %2</translation>
    </message>
    <message>
        <source>Taken back: %1</source>
        <translation>已撤销：%1</translation>
    </message>
    <message>
        <source>, lock closed</source>
        <translation>，已上锁</translation>
    </message>
    <message>
        <source>, THE LOCK IS OPEN</source>
        <translation>，EPROM 未上锁！</translation>
    </message>
    <message>
        <source>, lock not proven closed</source>
        <translation>，未能确认已上锁</translation>
    </message>
    <message>
        <source>Search ended after %2 s, servos found: %1</source>
        <translation>搜索结束，用时 %2 秒，找到舵机：%1</translation>
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
        <source>ID %1 · table saved before the first change: %2</source>
        <translation>ID %1 · 首次更改前已保存内存表：%2</translation>
    </message>
    <message>
        <source>Stop sent: torque off for everybody on the bus</source>
        <translation>已发送停止指令：总线上全部卸力</translation>
    </message>
    <message>
        <source>centre here</source>
        <translation>当前位置校中</translation>
    </message>
    <message>
        <source>restart</source>
        <translation>重启舵机</translation>
    </message>
    <message>
        <source>restore defaults</source>
        <translation>恢复出厂设置</translation>
    </message>
    <message>
        <source>identify</source>
        <translation>识别舵机</translation>
    </message>
    <message>
        <source>clear alarm</source>
        <translation>解除报警</translation>
    </message>
    <message>
        <source>close the EPROM lock</source>
        <translation>EPROM 上锁</translation>
    </message>
    <message>
        <source>interrupted writes</source>
        <translation>中断的写入</translation>
    </message>
    <message>
        <source>read the table</source>
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
        <source>no answer: ID %1</source>
        <translation>无应答：ID %1</translation>
    </message>
    <message>
        <source>at another rate, not reached: ID %1</source>
        <translation>波特率不同，未能到达：ID %1</translation>
    </message>
    <message>
        <source>a goal may still wait for its start: ID %1</source>
        <translation>可能仍有目标等待执行：ID %1</translation>
    </message>
    <message>
        <source>Stop checked: torque is off, ID %1</source>
        <translation>已确认停止：扭矩已关闭，ID %1</translation>
    </message>
    <message>
        <source>Stop checked: %1</source>
        <translation>停止检查：%1</translation>
    </message>
    <message>
        <source>Keep clear, and switch the supply off if in doubt.</source>
        <translation>请远离舵机，如有疑问请断开电源。</translation>
    </message>
    <message>
        <source>move</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>start the goals that wait</source>
        <translation>异步执行</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>扭矩</translation>
    </message>
    <message>
        <source>halt</source>
        <translation>停止运动</translation>
    </message>
    <message>
        <source>switch the mode</source>
        <translation>切换模式</translation>
    </message>
    <message>
        <source>look at the mode</source>
        <translation>查看模式</translation>
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
        <source>Servos may still be moving; switch off their supply.</source>
        <translation>舵机可能仍在运动，请切断其电源。</translation>
    </message>
    <message>
        <source>Not sent yet: the link is lost.</source>
        <translation>尚未发送：连接已断开。</translation>
    </message>
    <message>
        <source>The stop is sent first when the link is back.</source>
        <translation>连接恢复后会首先发送急停。</translation>
    </message>
    <message>
        <source>Not sent: no port is open.</source>
        <translation>未发送：没有打开的端口。</translation>
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
        <source>Not closed: ID %1 could not be stopped.</source>
        <translation>未关闭：ID %1 无法停止。</translation>
    </message>
    <message>
        <source>Press Esc for torque off, or switch off the supply.</source>
        <translation>按 Esc 卸力，或切断电源。</translation>
    </message>
    <message>
        <source>. Stopped before: ID %1</source>
        <translation>。关闭前已停止：ID %1</translation>
    </message>
    <message>
        <source>. STILL MOVING: ID %1</source>
        <translation>。仍在运动：ID %1</translation>
    </message>
    <message>
        <source>Switch off the supply to stop it.</source>
        <translation>要停止它，请切断电源。</translation>
    </message>
    <message>
        <source>the goal follows the control</source>
        <translation>目标跟随控件</translation>
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
        <source>. No answer: ID %1</source>
        <translation>。无应答：ID %1</translation>
    </message>
    <message>
        <source>These were expected and asked several times.</source>
        <translation>这些舵机应当存在，已多次询问。</translation>
    </message>
    <message>
        <source>unknown model</source>
        <translation>未知型号</translation>
    </message>
    <message>
        <source>Another servo answers under ID %1: %2</source>
        <translation>ID %1 下应答的是另一个舵机：%2</translation>
    </message>
    <message>
        <source>It takes the place of %1 in the list. Unfinished writes stay noted for that servo.</source>
        <translation>它在列表中取代 %1。未写完的记录仍归原舵机。</translation>
    </message>
    <message>
        <source>Stop sent, but not confirmed yet: ID %1</source>
        <translation>已发送停止，但尚未确认：ID %1</translation>
    </message>
    <message>
        <source>Not closed: the EPROM lock of ID %1 is still open.</source>
        <translation>未关闭：ID %1 的 EPROM 锁仍处于打开状态。</translation>
    </message>
    <message>
        <source>Check the cable and try again. The unfinished write stays in the journal.</source>
        <translation>请检查线缆后重试。未写完的写入仍保留在写入日志中。</translation>
    </message>
    <message>
        <source>. EPROM lock closed: ID %1</source>
        <translation>。已上锁 EPROM：ID %1</translation>
    </message>
    <message>
        <source>. EPROM LOCK STILL OPEN: ID %1</source>
        <translation>。EPROM 锁仍未关闭：ID %1</translation>
    </message>
    <message>
        <source>Connect again to finish or undo the write.</source>
        <translation>请重新连接，以完成或撤销该写入。</translation>
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
        <translation>扭矩</translation>
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
        <translation>限制 %1</translation>
    </message>
    <message>
        <source>not measured by %1</source>
        <translation>%1 不测量此项</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未读取</translation>
    </message>
    <message>
        <source>left to go</source>
        <translation>剩余行程</translation>
    </message>
    <message>
        <source>Voltage out of range</source>
        <translation>过压欠压</translation>
    </message>
    <message>
        <source>Encoder fault</source>
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
        <source>change ID</source>
        <translation>修改 ID</translation>
    </message>
    <message>
        <source>change rate</source>
        <translation>修改波特率</translation>
    </message>
    <message>
        <source>switch mode</source>
        <translation>切换模式</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>校准中位</translation>
    </message>
    <message>
        <source>restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>identify</source>
        <translation>闪灯识别</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>试用</translation>
    </message>
    <message>
        <source>not ended</source>
        <translation>未结束</translation>
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
        <source>left as it was</source>
        <translation>保持原样</translation>
    </message>
    <message>
        <source>before a change</source>
        <translation>修改之前</translation>
    </message>
    <message>
        <source>taken</source>
        <translation>手动保存</translation>
    </message>
    <message>
        <source>with all servos</source>
        <translation>整组保存</translation>
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
        <translation>寄存器</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>改为</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Occasion</source>
        <translation>来由</translation>
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
        <source>Came</source>
        <translation>出现</translation>
    </message>
    <message>
        <source>Went</source>
        <translation>消失</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Length</source>
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
        <source>read back: %1</source>
        <translation>回读：%1</translation>
    </message>
    <message>
        <source>not seen to go</source>
        <translation>未见消失</translation>
    </message>
    <message>
        <source>worked out from the limits, not reported by the servo</source>
        <translation>由限值推算，并非舵机上报</translation>
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
        <source>restore defaults</source>
        <translation>恢复出厂设置</translation>
    </message>
    <message>
        <source>undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>before commissioning</source>
        <translation>批量设置前</translation>
    </message>
</context>
<context>
    <name>MemorySheet</name>
    <message>
        <source>Memory table of %1, ID %2</source>
        <translation>%1 的内存表，ID %2</translation>
    </message>
    <message>
        <source>Firmware %1, map %2</source>
        <translation>固件 %1，内存表 %2</translation>
    </message>
    <message>
        <source>Port %1, %2 baud</source>
        <translation>端口 %1，%2 波特</translation>
    </message>
    <message>
        <source>Written down %1</source>
        <translation>记录时间 %1</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>键名</translation>
    </message>
</context>
<context>
    <name>MemoryTable</name>
    <message>
        <source>%1. A wrong value can make the servo unreachable or dangerous: you are asked before each write.</source>
        <translation>%1。写错可能导致舵机失联或发生危险：每次写入前都会询问。</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>无检测</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>内存</translation>
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
        <source>Address as the servo&apos;s sheet has it</source>
        <translation>舵机内存表中的地址</translation>
    </message>
    <message>
        <source>What the register is; • marks a value that differs from the first reading of this session</source>
        <translation>参数名称；• 表示与本次首次读取的值不同</translation>
    </message>
    <message>
        <source>The raw number in the servo, as it was read</source>
        <translation>舵机中读出的原始值</translation>
    </message>
    <message>
        <source>The same value with its unit, or its name</source>
        <translation>同一数值，带单位或名称</translation>
    </message>
    <message>
        <source>Where the register lives: EPROM is kept, SRAM is lost at power-off, feedback is measured, factory is the maker&apos;s</source>
        <translation>参数所在区域：EPROM 断电保存，SRAM 断电丢失，反馈为实测值，出厂为厂家参数</translation>
    </message>
    <message>
        <source>r: can only be read; rw: can be written; ⚠: asks before each write</source>
        <translation>r：只读；rw：可写；⚠：每次写入前询问</translation>
    </message>
    <message>
        <source>Value from the factory; empty where it is not known</source>
        <translation>出厂值；未知则为空</translation>
    </message>
    <message>
        <source>What may be written</source>
        <translation>允许写入的值</translation>
    </message>
    <message>
        <source>What became of the latest write, and how old the value is</source>
        <translation>最近一次写入的结果，以及数值读取了多久</translation>
    </message>
    <message>
        <source>%1: was %2 at the first reading of this session</source>
        <translation>%1：本次首次读取时为 %2</translation>
    </message>
    <message>
        <source>No default is known for this model.</source>
        <translation>该型号的默认值未知。</translation>
    </message>
    <message>
        <source>There is nothing to write.</source>
        <translation>此项不能写入。</translation>
    </message>
    <message>
        <source>New values: %1</source>
        <translation>可写入：%1</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未读取</translation>
    </message>
    <message>
        <source>not readable</source>
        <translation>读取失败</translation>
    </message>
    <message>
        <source>pending: %1</source>
        <translation>待写入：%1</translation>
    </message>
    <message>
        <source>changed since</source>
        <translation>之后已变</translation>
    </message>
    <message>
        <source>This register has not been read yet. Choose Read all.</source>
        <translation>该参数还没有读取。请点“读取全部”。</translation>
    </message>
    <message>
        <source>Read from the servo.</source>
        <translation>从舵机读取。</translation>
    </message>
    <message>
        <source>The latest reading failed, so no number is shown.</source>
        <translation>最近一次读取失败，因此不显示数值。</translation>
    </message>
    <message>
        <source>%1 is being written.</source>
        <translation>正在写入 %1。</translation>
    </message>
    <message>
        <source>%1 was written, read back, and is kept at power-off.</source>
        <translation>已写入 %1 并回读确认，断电保存。</translation>
    </message>
    <message>
        <source>%1 was written and read back; it is lost at power-off.</source>
        <translation>已写入 %1 并回读确认；断电后丢失。</translation>
    </message>
    <message>
        <source>%1 was written, but the servo shows another value.</source>
        <translation>已写入 %1，但舵机显示的是另一个值。</translation>
    </message>
    <message>
        <source>The servo did not take %1.</source>
        <translation>舵机没有接受 %1。</translation>
    </message>
    <message>
        <source>There was no answer while %1 was being written.</source>
        <translation>写入 %1 时没有应答。</translation>
    </message>
    <message>
        <source>It is not known what became of writing %1. Read the register again.</source>
        <translation>写入 %1 的结果未知。请重新读取该参数。</translation>
    </message>
    <message>
        <source>%1 was not written; the servo was not touched.</source>
        <translation>没有写入 %1；舵机未被改动。</translation>
    </message>
    <message>
        <source>%1 was written here, but the servo shows another value since: a temporary value is lost at power-off, or somebody else wrote.</source>
        <translation>这里曾写入 %1，但之后舵机显示另一个值：临时值断电丢失，或有其他程序写入。</translation>
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
        <source>The value shown is of this moment.</source>
        <translation>显示的是此刻的值。</translation>
    </message>
    <message>
        <source>The value shown was read %1 ago.</source>
        <translation>显示的值读取于 %1前。</translation>
    </message>
    <message>
        <source>write: no answer</source>
        <translation>写入：无应答</translation>
    </message>
</context>
<context>
    <name>Options</name>
    <message>
        <source>port to open and search: a device, tcp://host:port, sim:demo</source>
        <translation>要打开并搜索的端口：设备、tcp://主机:端口、sim:demo</translation>
    </message>
    <message>
        <source>baud rate of the port, or auto</source>
        <translation>端口波特率，或 auto</translation>
    </message>
    <message>
        <source>auto, feetech, modbus or lx</source>
        <translation>auto、feetech、modbus 或 lx</translation>
    </message>
    <message>
        <source>language of the interface: en or zh_CN</source>
        <translation>界面语言：en 或 zh_CN</translation>
    </message>
    <message>
        <source>system, light or dark</source>
        <translation>system、light 或 dark</translation>
    </message>
    <message>
        <source>ID of the servo to select</source>
        <translation>要选中的舵机 ID</translation>
    </message>
    <message>
        <source>write the window to this PNG file and end</source>
        <translation>把窗口写入此 PNG 文件后退出</translation>
    </message>
    <message>
        <source>milliseconds until the screenshot</source>
        <translation>截图前等待的毫秒数</translation>
    </message>
    <message>
        <source>--%1: &quot;%2&quot; is no number that fits</source>
        <translation>--%1：“%2”不是合适的数字</translation>
    </message>
    <message>
        <source>--protocol: there is no &quot;%1&quot;</source>
        <translation>--protocol：没有“%1”</translation>
    </message>
    <message>
        <source>--theme: there is no &quot;%1&quot;</source>
        <translation>--theme：没有“%1”</translation>
    </message>
    <message>
        <source>Bench program for serial bus servos</source>
        <translation>串行总线舵机调试程序</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not understood</source>
        <translation>无法理解“%1”</translation>
    </message>
    <message>
        <source>size of the window, such as 1280x800</source>
        <translation>窗口大小，如 1280x800</translation>
    </message>
    <message>
        <source>--size: &quot;%1&quot; is no size such as 1280x800</source>
        <translation>--size：“%1”不是 1280x800 这样的大小</translation>
    </message>
    <message>
        <source>--page: there is no &quot;%1&quot;</source>
        <translation>--page：没有“%1”</translation>
    </message>
    <message>
        <source>page to show: operate, memory, sweep, step, snapshots, commission, history</source>
        <translation>要显示的页面：operate、memory、sweep、step、snapshots、commission、history</translation>
    </message>
</context>
<context>
    <name>RegisterHelp</name>
    <message>
        <source>, </source>
        <comment>between items of a list</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>One step: %1</source>
        <translation>每一单位：%1</translation>
    </message>
    <message>
        <source>Range: %1</source>
        <translation>范围：%1</translation>
    </message>
    <message>
        <source>Torque has to be off while this is written: ServoDesk switches it off.</source>
        <translation>写入时扭矩必须关闭：ServoDesk 会先卸力。</translation>
    </message>
    <message>
        <source>Both limits at 0 switch the mode: ServoDesk takes torque off for that.</source>
        <translation>两个限制都为 0 会切换模式：ServoDesk 会先卸力。</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>默认：%1</translation>
    </message>
    <message>
        <source>Default: not known</source>
        <translation>默认：未知</translation>
    </message>
    <message>
        <source>Its meaning depends on: %1.</source>
        <translation>其含义取决于：%1。</translation>
    </message>
    <message>
        <source>That has not been read, so the unit shown is the usual one.</source>
        <translation>该参数尚未读取，因此按通常的单位显示。</translation>
    </message>
    <message>
        <source>Depends on it: %1.</source>
        <translation>受其影响：%1。</translation>
    </message>
    <message>
        <source>This servo has no sensor for it: the number means nothing.</source>
        <translation>该舵机没有相应的检测：此值无意义。</translation>
    </message>
    <message>
        <source>Writing it may move the shaft or switch torque on.</source>
        <translation>写入可能使输出轴转动或打开扭矩。</translation>
    </message>
    <message>
        <source>Kept after power-off: ServoDesk opens the lock, writes, reads back and locks again.</source>
        <translation>掉电保存：自动解锁、写入、回读并重新上锁。</translation>
    </message>
    <message>
        <source>Kept after power-off: this family stores every write at once. ServoDesk reads it back.</source>
        <translation>掉电保存：该系列每次写入都立即保存。ServoDesk 会回读确认。</translation>
    </message>
    <message>
        <source>Kept after power-off: ServoDesk writes, reads back and sends the save command.</source>
        <translation>掉电保存：写入、回读并发送保存指令。</translation>
    </message>
    <message>
        <source>Acts at once and is lost at power-off.</source>
        <translation>立即生效，断电后丢失。</translation>
    </message>
    <message>
        <source>Acts at once. Nobody says whether it survives power-off.</source>
        <translation>立即生效。资料没有说明断电后是否保存。</translation>
    </message>
</context>
<context>
    <name>RestoreWords</name>
    <message>
        <source>%1 (last read: %2)</source>
        <translation>%1（最近读到：%2）</translation>
    </message>
    <message>
        <source>%1 (value unknown)</source>
        <translation>%1（数值未知）</translation>
    </message>
    <message>
        <source>The old values could not be put back: %1.</source>
        <translation>未能恢复原值：%1。</translation>
    </message>
    <message>
        <source>Read the table and write the rest again; the journal knows what was to be written.</source>
        <translation>请重新读取内存表并再写入其余的行；写入日志里有要写入的内容。</translation>
    </message>
    <message>
        <source>When the servo answers again, open Port → Interrupted writes: Undo there puts the old values back.</source>
        <translation>舵机恢复应答后，请打开“端口 → 中断的写入”：在那里撤销即可恢复原值。</translation>
    </message>
    <message>
        <source>The table that was saved before the first write has the old values.</source>
        <translation>首次写入前保存的内存表中有原值。</translation>
    </message>
    <message>
        <source>The EPROM lock is open.</source>
        <translation>EPROM 未上锁。</translation>
    </message>
    <message>
        <source>The EPROM lock is not proven closed.</source>
        <translation>不能确认 EPROM 已上锁。</translation>
    </message>
</context>
<context>
    <name>ServoRow</name>
    <message>
        <source>Feetech</source>
        <translation>飞特</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>过温</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>电压异常</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未读取</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>无应答</translation>
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
        <source>EPROM lock open, opened by ServoDesk</source>
        <translation>EPROM 未上锁（由 ServoDesk 打开）</translation>
    </message>
    <message>
        <source>EPROM lock open</source>
        <translation>EPROM 未上锁</translation>
    </message>
    <message>
        <source>Answers late</source>
        <translation>应答迟缓</translation>
    </message>
    <message>
        <source>Unknown firmware: read only</source>
        <translation>未知固件：只读</translation>
    </message>
    <message>
        <source>Firmware %1 known (%2)</source>
        <translation>已知有固件 %1（%2）</translation>
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
        <source>not known</source>
        <translation>未知</translation>
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
        <source>Line: %1</source>
        <translation>接口：%1</translation>
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
        <source>Family unclear: read only</source>
        <translation>系列不明：只读</translation>
    </message>
    <message>
        <source>unreadable answers</source>
        <translation>应答无法识别</translation>
    </message>
    <message>
        <source>EPROM lock not proven closed, opened by ServoDesk</source>
        <translation>EPROM 未确认上锁（由 ServoDesk 打开）</translation>
    </message>
    <message>
        <source>EPROM lock not proven closed</source>
        <translation>EPROM 未确认上锁</translation>
    </message>
</context>
<context>
    <name>ServoTasks</name>
    <message>
        <source>The alarm is gone.</source>
        <translation>报警已解除。</translation>
    </message>
    <message>
        <source>Turn back a little…</source>
        <translation>往回转一点…</translation>
    </message>
    <message>
        <source>Hold where it is…</source>
        <translation>在当前位置保持…</translation>
    </message>
    <message>
        <source>Reset the fault</source>
        <translation>故障复位</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Clear alarm</source>
        <translation>清除报警</translation>
    </message>
    <message>
        <source>Each alarm lets go in its own way. The values are read again as long as this is open; reading writes nothing.</source>
        <translation>每种报警有各自的解除方式。此窗口打开期间不断读取数值；读取不写入任何内容。</translation>
    </message>
    <message>
        <source>Do what releases the alarm</source>
        <translation>执行解除报警的操作</translation>
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
        <source>The alarms of this servo, with the value and limit of each</source>
        <translation>该舵机的报警，以及各自的数值和限值</translation>
    </message>
    <message>
        <source>Not read.</source>
        <translation>未读取。</translation>
    </message>
    <message>
        <source>This family reports no alarms: this one is worked out from the value and its limit.</source>
        <translation>该系列不报告报警：此项由数值与限值推算得出。</translation>
    </message>
    <message>
        <source>Let the shaft turn back?</source>
        <translation>让输出轴往回转一点？</translation>
    </message>
    <message>
        <source>It turns from %1 to %2, away from the stall, and holds there with its full torque.</source>
        <translation>将从 %1 转到 %2，离开堵转位置，并以全部扭矩保持在那里。</translation>
    </message>
    <message>
        <source>Turn back</source>
        <translation>往回转</translation>
    </message>
    <message>
        <source>Switch torque on?</source>
        <translation>打开扭矩？</translation>
    </message>
    <message>
        <source>Its present place, %1, becomes its goal, and torque holds it there.</source>
        <translation>当前位置 %1 成为目标，并以扭矩保持。</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>打开扭矩</translation>
    </message>
    <message>
        <source>Remove what blocks it and keep your fingers away from the mechanism.</source>
        <translation>请先排除卡阻，手指远离机构，防止夹手。</translation>
    </message>
    <message>
        <source>An alarm is still there, or has come back: its cause lasts.</source>
        <translation>报警仍在，或再次出现：原因尚未消除。</translation>
    </message>
    <message>
        <source>This servo has no command for it.</source>
        <translation>该舵机没有此指令。</translation>
    </message>
    <message>
        <source>Centre here</source>
        <translation>当前位置设为中位</translation>
    </message>
    <message>
        <source>The place where the shaft stands now becomes the middle of its range. Torque is switched off first, so that nothing jumps to the old goal, and stays off until you switch it on. The offset is kept at power-off.</source>
        <translation>输出轴当前所在位置成为行程中位。先关闭扭矩，以免跳向旧目标；扭矩保持关闭，直到您打开。校正值断电后保存。</translation>
    </message>
    <message>
        <source>Take torque off and make the present position the middle</source>
        <translation>关闭扭矩，把当前位置设为中位</translation>
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
        <source>Offset</source>
        <translation>校正值</translation>
    </message>
    <message>
        <source>The present position is the middle now.</source>
        <translation>当前位置已设为中位。</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>识别</translation>
    </message>
    <message>
        <source>The LED of this servo blinks for some seconds; then its setting is put back as it was. Nothing moves. A board without LED shows nothing.</source>
        <translation>该舵机的 LED 闪烁几秒，然后恢复原来的设置。舵机不会转动。没有 LED 的电路板无显示。</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>再来一次</translation>
    </message>
    <message>
        <source>Let it blink once more</source>
        <translation>再闪一次</translation>
    </message>
    <message>
        <source>The LED is as it was before.</source>
        <translation>LED 设置已恢复原样。</translation>
    </message>
    <message>
        <source>Interrupted writes</source>
        <translation>中断的写入</translation>
    </message>
    <message>
        <source>These changes were begun and have no end in the journal: a cable was pulled, power failed, or the program was ended. Looking at them wrote nothing. Choose what to do with each; what is left for later is offered again at the next connection.</source>
        <translation>这些修改已开始，但日志中没有结束：可能拔了线、断了电，或程序被终止。查看时没有写入任何内容。请逐项选择处理方式；留到以后的会在下次连接时再次提示。</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Put the old values back, prove them, and close the lock</source>
        <translation>写回旧值，回读确认，并上锁</translation>
    </message>
    <message>
        <source>Forget…</source>
        <translation>放弃…</translation>
    </message>
    <message>
        <source>Strike it from the journal; the servo is left as it is</source>
        <translation>从日志中划去；舵机保持现状</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>以后再说</translation>
    </message>
    <message>
        <source>Close this list; nothing is written</source>
        <translation>关闭此列表；不写入任何内容</translation>
    </message>
    <message>
        <source>Writes without an end in the journal</source>
        <translation>日志中没有结束的写入</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>正在处理…</translation>
    </message>
    <message>
        <source>Forget this change?</source>
        <translation>放弃这次修改？</translation>
    </message>
    <message>
        <source>ServoDesk no longer offers to finish or undo it. The servo is left as it is.</source>
        <translation>ServoDesk 不再提示完成或撤销。舵机保持现状。</translation>
    </message>
    <message>
        <source>Its EPROM lock may stand open, and its values may be half old and half new.</source>
        <translation>它的 EPROM 可能没有上锁，数值可能一半是旧的、一半是新的。</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>No change was left open.</source>
        <translation>没有未完成的修改。</translation>
    </message>
    <message>
        <source>The old values are back.</source>
        <translation>旧值已写回。</translation>
    </message>
    <message>
        <source>The change has been finished.</source>
        <translation>修改已完成。</translation>
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
        <source>change of mode</source>
        <translation>切换模式</translation>
    </message>
    <message>
        <source>centre here</source>
        <translation>设为中位</translation>
    </message>
    <message>
        <source>restore defaults</source>
        <translation>恢复默认值</translation>
    </message>
    <message>
        <source>identify</source>
        <translation>识别</translation>
    </message>
    <message>
        <source>another servo, or other values: hands off</source>
        <translation>是另一个舵机，或数值不符：不予处理</translation>
    </message>
    <message>
        <source>it does not answer</source>
        <translation>没有应答</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>What</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>修改</translation>
    </message>
    <message>
        <source>Found now</source>
        <translation>现状</translation>
    </message>
    <message>
        <source>EPROM lock</source>
        <translation>EPROM 锁</translation>
    </message>
    <message>
        <source>Restart the servo</source>
        <translation>重启舵机</translation>
    </message>
    <message>
        <source>Torque is switched off first: a load that hangs on the shaft will drop. What was written temporarily is lost, and the turn count with it. The whole bus keeps quiet until the servo answers again, two seconds at most.</source>
        <translation>先关闭扭矩：悬挂的负载会落下。临时写入的值和圈数都会丢失。在舵机恢复应答之前整条总线保持安静，最多两秒。</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>重启</translation>
    </message>
    <message>
        <source>Take torque off, restart the servo and wait for it</source>
        <translation>关闭扭矩，重启舵机并等待其应答</translation>
    </message>
    <message>
        <source>The servo has restarted and answers again.</source>
        <translation>舵机已重启并恢复应答。</translation>
    </message>
    <message>
        <source>It took %1 ms. Torque is off.</source>
        <translation>用时 %1 毫秒。扭矩已关闭。</translation>
    </message>
    <message>
        <source>No setting differs from before.</source>
        <translation>没有参数与之前不同。</translation>
    </message>
    <message>
        <source>Settings that differ now (%1): %2</source>
        <translation>与之前不同的参数（%1 项）：%2</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>恢复默认值</translation>
    </message>
    <message>
        <source>The servo goes back to the settings stored in it. ServoDesk takes torque off and saves the present table to a file first.</source>
        <translation>舵机恢复为其内部存储的参数。ServoDesk 先关闭扭矩，并把当前内存表保存到文件。</translation>
    </message>
    <message>
        <source>Save and restore</source>
        <translation>保存并恢复</translation>
    </message>
    <message>
        <source>Save the table, restore the defaults, find the servo again</source>
        <translation>保存内存表，恢复默认值，再找到舵机</translation>
    </message>
    <message>
        <source>Baud rate: may go back to the stored one; ServoDesk looks for the servo at all rates of its family.
ID: should stay; some servos go back to 1. If another servo has ID 1, connect this one alone.
Limits, gains and offset: go back, so positions may mean other angles afterwards.</source>
        <translation>波特率：可能恢复为存储值；ServoDesk 会在该系列的所有波特率上查找舵机。
ID：一般不变；个别舵机会恢复为 1。如有其他舵机使用 ID 1，请只接这一个。
限位、增益和校正值：会恢复，之后同一位置可能对应不同角度。</translation>
    </message>
    <message>
        <source>The defaults have been restored.</source>
        <translation>默认值已恢复。</translation>
    </message>
    <message>
        <source>ID: %1 → %2, baud rate: %3 → %4</source>
        <translation>ID：%1 → %2，波特率：%3 → %4</translation>
    </message>
    <message>
        <source>The settings before are in %1</source>
        <translation>之前的参数保存在 %1</translation>
    </message>
    <message>
        <source>The rate of this servo is fixed.</source>
        <translation>该舵机的波特率是固定的。</translation>
    </message>
    <message>
        <source>It answers at this rate now.</source>
        <translation>当前就是这个波特率。</translation>
    </message>
    <message>
        <source>From then on it answers at %1 baud only. ServoDesk follows it; other programs have to be told.</source>
        <translation>此后只以 %1 波特率应答。ServoDesk 会自动跟随；其他程序需要另行设置。</translation>
    </message>
    <message>
        <source>Other servos that stay at %1 baud: %2. A program that uses one rate no longer reaches all of them.</source>
        <translation>仍为 %1 波特率的其他舵机：%2 个。只用一个波特率的程序将无法访问全部舵机。</translation>
    </message>
    <message>
        <source>Set baud rate</source>
        <translation>设置波特率</translation>
    </message>
    <message>
        <source>The new rate is tried first: only one that this adapter can run is written. It is kept at power-off.</source>
        <translation>先试验新波特率：适配器支持才会写入。断电后保存。</translation>
    </message>
    <message>
        <source>Write the rate, find the servo there, and close its lock</source>
        <translation>写入波特率，在新波特率找到舵机，并上锁</translation>
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
        <source>The rates that this family knows</source>
        <translation>该系列支持的波特率</translation>
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
        <source>It has this ID now.</source>
        <translation>当前就是这个 ID。</translation>
    </message>
    <message>
        <source>ID %1 belongs to another servo (%2). Two servos with one ID answer at the same time, and nobody is understood.</source>
        <translation>ID %1 属于另一个舵机（%2）。两个舵机使用同一 ID 会同时应答，谁都无法识别。</translation>
    </message>
    <message>
        <source>ID %1 is asked first: it is written only if nobody answers to it.</source>
        <translation>会先询问 ID %1：没有舵机应答才写入。</translation>
    </message>
    <message>
        <source>Set ID</source>
        <translation>设置 ID</translation>
    </message>
    <message>
        <source>The servo answers under the new ID at once and keeps it at power-off. ServoDesk follows it; other programs have to be told.</source>
        <translation>舵机立即使用新 ID，断电后保存。ServoDesk 会自动跟随；其他程序需要另行设置。</translation>
    </message>
    <message>
        <source>Prove the ID free, write it, and close the lock there</source>
        <translation>确认 ID 空闲，写入，并在新 ID 上锁</translation>
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
        <translation>新 ID，%1 到 %2</translation>
    </message>
    <message>
        <source>IDs on this bus</source>
        <translation>总线上的 ID</translation>
    </message>
    <message>
        <source>Who has which ID, and free ones; choose a free one</source>
        <translation>各 ID 由谁使用，以及空闲的 ID；请选择一个空闲的</translation>
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
        <source>End it now; what has begun ends safely first</source>
        <translation>立即结束；已开始的步骤会先安全完成</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close this dialog; what is running goes on to its end</source>
        <translation>关闭此对话框；正在进行的操作会继续到结束</translation>
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
        <source>What to do: %1</source>
        <translation>处理方法：%1</translation>
    </message>
    <message>
        <source>Not everything ended as it should.</source>
        <translation>并非全部正常完成。</translation>
    </message>
    <message>
        <source>The servo answers as ID %1 at %2 baud.</source>
        <translation>舵机现以 ID %1、%2 波特率应答。</translation>
    </message>
    <message>
        <source>The servo answers as ID %1.</source>
        <translation>舵机现以 ID %1 应答。</translation>
    </message>
    <message>
        <source>Changes that were begun and have no end in the journal, because a cable was pulled, power failed, or the program was ended, are listed here.</source>
        <translation>因拔线、断电或程序被结束而没有写完的更改会列在这里。</translation>
    </message>
    <message>
        <source>settings of a test</source>
        <translation>测试期间的设置</translation>
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
        <source>Look on this port</source>
        <translation>在此端口查找</translation>
    </message>
    <message>
        <source>Read the servos on this port and compare them with these changes; nothing is written</source>
        <translation>读取此端口上的舵机并与这些更改对比；不写入任何内容</translation>
    </message>
    <message>
        <source>Changes that were begun on other ports are open. If the adapter has another name now, look for them here:</source>
        <translation>在其他端口上开始的更改尚未写完。如果适配器的端口名已改变，请在此处查找：</translation>
    </message>
    <message>
        <source>%1, %2: %3, on %4, %5</source>
        <translation>%1，%2：%3，端口 %4，%5</translation>
    </message>
    <message>
        <source>The servo has the settings from before the test: nothing had to be put back.</source>
        <translation>舵机已是测试前的设置，无需恢复。</translation>
    </message>
    <message>
        <source>The settings from before the test have been put back.</source>
        <translation>已恢复测试前的设置。</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Put the settings from before the test back and prove them</source>
        <translation>恢复测试前的设置并核对</translation>
    </message>
    <message>
        <source>Write what is missing, prove it, and close the lock. Undo then takes back the whole change</source>
        <translation>写入缺少的部分，核对并关闭锁。之后“撤销”会撤回整个修改</translation>
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
        <source>some new, some old values</source>
        <translation>部分新值，部分原值</translation>
    </message>
    <message>
        <source>something answers, but nothing readable</source>
        <translation>有应答，但无法识别</translation>
    </message>
    <message>
        <source>Left as they are, because they have another value since or would move the servo: %1</source>
        <translation>保持不变，因为之后已是其他数值，或写入会使舵机转动：%1</translation>
    </message>
    <message>
        <source>Nothing was written; the change is no longer offered.</source>
        <translation>没有写入任何内容；不再提示此次改动。</translation>
    </message>
    <message>
        <source>other values since, which stay</source>
        <translation>之后已是其他数值，保持不变</translation>
    </message>
    <message>
        <source>Nothing was written: the change is no longer open, or the port on which it was begun exists again.</source>
        <translation>未写入任何内容：该更改已不再处于未完成状态，或开始该更改的端口已重新出现。</translation>
    </message>
    <message>
        <source>Changes that were begun on other ports are open. Connect to that port to finish or undo them:</source>
        <translation>有在其他端口上开始的更改尚未完成。请连接到相应端口以完成或撤销：</translation>
    </message>
    <message>
        <source>still under way in another program</source>
        <translation>另一个程序仍在进行</translation>
    </message>
    <message>
        <source>It did not answer at the end and may be at either baud rate: %1 or %2. Port → Interrupted writes looks for it at both; so does a search at these rates.</source>
        <translation>舵机最后没有应答，可能处于两个波特率中的任意一个：%1 或 %2。“端口 → 中断的写入”会在这两个波特率下查找，以这些波特率搜索也可以。</translation>
    </message>
    <message>
        <source>It did not answer at the end and may have either ID: %1 or %2. Port → Interrupted writes looks for it at both; so does a search.</source>
        <translation>舵机最后没有应答，ID 可能是 %1 或 %2。“端口 → 中断的写入”会在这两个 ID 下查找，搜索也可以。</translation>
    </message>
    <message>
        <source>Another program that is still running is making these changes. They are left to it. If it ends before they are complete, they are offered here.</source>
        <translation>另一个仍在运行的程序正在进行这些更改，本程序不会干预。如果该程序在完成前结束，这些更改会在此列出。</translation>
    </message>
    <message>
        <source>A change that is still under way in another program is left to it.</source>
        <translation>仍由另一个程序进行中的更改由该程序完成。</translation>
    </message>
    <message>
        <source>The change stays open and is offered again.</source>
        <translation>该更改仍未完成，之后会再次列出。</translation>
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
        <translation>扭矩</translation>
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
        <source>Moving</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>ID %1 · %2</source>
        <translation>ID %1 · %2</translation>
    </message>
    <message>
        <source>over: %1</source>
        <translation>已解除：%1</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>answers again</source>
        <translation>恢复应答</translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation>紧急停止</translation>
    </message>
    <message>
        <source>%1 (worked out)</source>
        <translation>%1（推算）</translation>
    </message>
</context>
<context>
    <name>UndoWords</name>
    <message>
        <source>ID %1 · %2</source>
        <translation>ID %1 · %2</translation>
    </message>
    <message>
        <source>ID %1 · %2: %3 → %4</source>
        <translation>ID %1 · %2：%3 → %4</translation>
    </message>
    <message>
        <source>%1 settings</source>
        <translation>%1 项设置</translation>
    </message>
</context>
<context>
    <name>ValueEditor</name>
    <message>
        <source>, </source>
        <comment>between items of a list</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>Choose one of: %1.</source>
        <translation>请从中选择：%1。</translation>
    </message>
    <message>
        <source>Type a whole number, %1.</source>
        <translation>请输入整数，范围 %1。</translation>
    </message>
    <message>
        <source>Type a whole number, %1, or a value with its unit, such as %2.</source>
        <translation>请输入整数（范围 %1），或带单位的数值，例如 %2。</translation>
    </message>
    <message>
        <source>There is no value.</source>
        <translation>没有输入数值。</translation>
    </message>
    <message>
        <source>“%1” is less than one step of this register and would become 0.</source>
        <translation>“%1”不足该参数的一个单位，会变成 0。</translation>
    </message>
    <message>
        <source>“%1” is not a value this register understands.</source>
        <translation>“%1”不是该参数能识别的数值。</translation>
    </message>
    <message>
        <source>%1 is not one of the documented values, and the servo may do anything with it.</source>
        <translation>%1 不在资料说明的数值之内，舵机的反应无法预料。</translation>
    </message>
    <message>
        <source>%1 is outside what this register accepts (%2).</source>
        <translation>%1 超出该参数的允许范围（%2）。</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>没有写入任何内容。</translation>
    </message>
    <message>
        <source> </source>
        <comment>between sentences</comment>
        <translation> </translation>
    </message>
</context>
<context>
    <name>WriteQuestion</name>
    <message>
        <source> </source>
        <comment>between sentences</comment>
        <translation> </translation>
    </message>
    <message>
        <source>The value is lost at power-off.</source>
        <translation>该值断电后丢失。</translation>
    </message>
    <message>
        <source>In this mode the shaft turns without end as soon as it is given a command. Clear the mechanism first.</source>
        <translation>在该模式下，一旦收到指令输出轴就会持续转动。请先清空机构周围。</translation>
    </message>
    <message>
        <source>In this mode no angle limit keeps the shaft inside its range. Clear the mechanism first.</source>
        <translation>在该模式下没有角度限制约束输出轴。请先清空机构周围。</translation>
    </message>
    <message>
        <source>Change the mode to “%1”?</source>
        <translation>切换到“%1”模式？</translation>
    </message>
    <message>
        <source>Writing %1 to %2 takes the servo from “%3” to “%4”.</source>
        <translation>向 %2 写入 %1 会使舵机从“%3”切换到“%4”。</translation>
    </message>
    <message>
        <source>Writing %1 to %2 leads to “%3”.</source>
        <translation>向 %2 写入 %1 会切换到“%3”。</translation>
    </message>
    <message>
        <source>The command of the new mode, %1, is set to 0.</source>
        <translation>新模式的指令 %1 会清零。</translation>
    </message>
    <message>
        <source>ServoDesk switches torque off first, writes, and reads back.</source>
        <translation>ServoDesk 先卸力，再写入并回读。</translation>
    </message>
    <message>
        <source>Torque stays off until you switch it on.</source>
        <translation>扭矩保持关闭，直到您打开。</translation>
    </message>
    <message>
        <source>Change the mode</source>
        <translation>切换模式</translation>
    </message>
    <message>
        <source>From now on the servo answers as %1. Programs that know it by its old ID no longer find it.</source>
        <translation>此后舵机以 ID %1 应答。按原 ID 使用它的程序将找不到它。</translation>
    </message>
    <message>
        <source>The servo leaves this rate. ServoDesk follows it; other programs and servos stay where they are.</source>
        <translation>舵机将离开当前波特率。ServoDesk 会跟随；其他程序和舵机保持不变。</translation>
    </message>
    <message>
        <source>Programs that wait for its answers in another way may take the servo for lost.</source>
        <translation>按原方式等待应答的程序可能认为舵机失联。</translation>
    </message>
    <message>
        <source>A protection that is switched off no longer saves motor and gears: they can burn or break.</source>
        <translation>关闭的保护不再保护电机和齿轮：可能烧毁或损坏。</translation>
    </message>
    <message>
        <source>Direction, feedback and drive of the motor change. A wrong value can make it run away.</source>
        <translation>电机的方向、反馈和驱动方式会改变。写错可能使其失控。</translation>
    </message>
    <message>
        <source>Every position means another angle afterwards. Clear the mechanism before torque is switched on.</source>
        <translation>此后每个位置对应不同的角度。打开扭矩前请清空机构周围。</translation>
    </message>
    <message>
        <source>A wrong value can make the servo unreachable or dangerous. Note the old value before you go on.</source>
        <translation>写错可能导致舵机失联或发生危险。继续之前请记下原值。</translation>
    </message>
    <message>
        <source>Write %1?</source>
        <translation>写入 %1？</translation>
    </message>
    <message>
        <source>From %1 to %2.</source>
        <translation>从 %1 改为 %2。</translation>
    </message>
    <message>
        <source>To %1; the present value could not be read.</source>
        <translation>改为 %1；当前值无法读取。</translation>
    </message>
    <message>
        <source>Torque is switched off first and stays off.</source>
        <translation>先卸力，并保持关闭。</translation>
    </message>
    <message>
        <source>The shaft turns as soon as this is written: keep clear of the mechanism.</source>
        <translation>写入后输出轴立即转动：请远离机构。</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
</context>
<context>
    <name>cli</name>
    <message>
        <source>&quot;%1&quot; is no ID; IDs are 0 to 253</source>
        <translation>“%1” 不是 ID；ID 为 0 到 253</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no range of IDs; write for example 1-20</source>
        <translation>“%1” 不是 ID 范围；请写成例如 1-20</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no whole number from %2 to %3</source>
        <translation>“%1” 不是 %2 到 %3 之间的整数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number above 0</source>
        <translation>“%1” 不是大于 0 的数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no baud rate of these servos (%2)</source>
        <translation>“%1” 不是这类舵机的波特率（%2）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must have the form KEY=VALUE, without blanks</source>
        <translation>“%1” 应写成 KEY=VALUE（名称=数值），中间不留空格</translation>
    </message>
    <message>
        <source>did you mean %1?</source>
        <translation>是不是 %1？</translation>
    </message>
    <message>
        <source>give one baud rate</source>
        <translation>请给出一个波特率</translation>
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
        <source>Offset</source>
        <translation>位置校正</translation>
    </message>
    <message>
        <source>EPROM lock: %1</source>
        <translation>EPROM 锁标志：%1</translation>
    </message>
    <message>
        <source>Servo %1 has restarted.</source>
        <translation>舵机 %1 已重启。</translation>
    </message>
    <message>
        <source>give a servo another ID, which is proven free first</source>
        <translation>修改舵机 ID，先确认新 ID 无人使用</translation>
    </message>
    <message>
        <source>its ID now</source>
        <translation>现在的 ID</translation>
    </message>
    <message>
        <source>its new ID, 0 to 253</source>
        <translation>新的 ID，0 到 253</translation>
    </message>
    <message>
        <source>give a servo another baud rate</source>
        <translation>修改舵机波特率</translation>
    </message>
    <message>
        <source>the servo</source>
        <translation>舵机的 ID</translation>
    </message>
    <message>
        <source>the new baud rate</source>
        <translation>新的波特率</translation>
    </message>
    <message>
        <source>make the present position the middle</source>
        <translation>把当前位置设为中位</translation>
    </message>
    <message>
        <source>restart a servo and wait for it</source>
        <translation>重启舵机并等待其应答</translation>
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
        <source>no, only its family</source>
        <translation>否，只知道系列</translation>
    </message>
    <message>
        <source>Series, map</source>
        <translation>系列、内存表</translation>
    </message>
    <message>
        <source>Protocol, line</source>
        <translation>协议、线路</translation>
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
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>扭矩开关</translation>
    </message>
    <message>
        <source>EPROM lock</source>
        <translation>EPROM 锁标志</translation>
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
        <source>what a servo is and its state, alarms with their remedy</source>
        <translation>舵机的型号与状态，以及报警的解除方法</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must have the form ID=POS, without blanks</source>
        <translation>“%1” 应写成 ID=POS（ID=位置），中间不留空格</translation>
    </message>
    <message>
        <source>servo %1 is given twice</source>
        <translation>舵机 %1 给了两次</translation>
    </message>
    <message>
        <source>--how is write, sync or async</source>
        <translation>--how 只能是 write（普通写）、sync（同步写）或 async（异步写）</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>运动中</translation>
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
        <source>give goals; what is not given is not written</source>
        <translation>给出目标；没给的参数不会写入</translation>
    </message>
    <message>
        <source>raw (1=2048) or with its unit (1=90deg; in speed mode 1=30rpm)</source>
        <translation>原始值（1=2048）或带单位（1=90deg；恒速模式 1=30rpm）</translation>
    </message>
    <message>
        <source>raw or with its unit</source>
        <translation>原始值，或带单位</translation>
    </message>
    <message>
        <source>travel time in milliseconds (SCS)</source>
        <translation>运行时间，毫秒（SCS）</translation>
    </message>
    <message>
        <source>wait until the servos have arrived</source>
        <translation>等待舵机到位</translation>
    </message>
    <message>
        <source>one by one, in one packet, or held and released together; released to several Feetech servos at once, goals that other programs hold on the bus start as well</source>
        <translation>普通写、同步写，或异步写后一起执行；对多个飞特舵机一起执行时，其他程序留在总线上的目标也会执行</translation>
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
        <source>simulated bus</source>
        <translation>仿真总线</translation>
    </message>
    <message>
        <source>list the ports of this computer</source>
        <translation>列出本机的端口</translation>
    </message>
    <message>
        <source>no valid frame</source>
        <translation>不是有效的数据包</translation>
    </message>
    <message>
        <source>write bytes as hexadecimal pairs: FF FF 01 02 01 FB</source>
        <translation>请用十六进制写出各字节，例如：FF FF 01 02 01 FB</translation>
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
        <source>Nothing came back.</source>
        <translation>没有收到任何应答。</translation>
    </message>
    <message>
        <source>send bytes as they are and show what comes back</source>
        <translation>原样发送字节并显示应答</translation>
    </message>
    <message>
        <source>a whole frame with its checksum</source>
        <translation>完整的数据包，含校验和</translation>
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
        <source>read single registers</source>
        <translation>读取个别寄存器</translation>
    </message>
    <message>
        <source>register names, as dump shows them</source>
        <translation>寄存器名称，见 dump 的输出</translation>
    </message>
    <message>
        <source>another servo answers: left alone</source>
        <translation>应答的是另一个舵机：不予处理</translation>
    </message>
    <message>
        <source>it does not answer</source>
        <translation>没有应答</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>What</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>修改内容</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>检查结果</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>锁标志</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>已处理</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>No change was left open.</source>
        <translation>没有未完成的修改。</translation>
    </message>
    <message>
        <source>give --finish or --undo, not both</source>
        <translation>--finish 和 --undo 只能选一个</translation>
    </message>
    <message>
        <source>show changes that were interrupted; finish or undo them</source>
        <translation>显示中断的修改，并完成或撤销</translation>
    </message>
    <message>
        <source>complete them</source>
        <translation>完成这些修改</translation>
    </message>
    <message>
        <source>put the old values back</source>
        <translation>恢复旧值</translation>
    </message>
    <message>
        <source>The servo answers as ID %1 at %2 baud.</source>
        <translation>舵机以 ID %1、波特率 %2 应答。</translation>
    </message>
    <message>
        <source>No register has changed.</source>
        <translation>没有寄存器改变。</translation>
    </message>
    <message>
        <source>Changed registers: %1</source>
        <translation>改变的寄存器：%1</translation>
    </message>
    <message>
        <source>The present settings are saved in %1</source>
        <translation>当前参数已保存到 %1</translation>
    </message>
    <message>
        <source>Restoring</source>
        <translation>正在恢复</translation>
    </message>
    <message>
        <source>put back the stored parameters (0x06); ID and baud rate may change, so connect this servo alone</source>
        <translation>恢复备份的参数（0x06）；ID 和波特率可能改变，请只接这一个舵机</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>型号编号</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>固件版本</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>内存表</translation>
    </message>
    <message>
        <source>Baud</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>two servos with this ID suspected</source>
        <translation>怀疑有两个舵机用此 ID</translation>
    </message>
    <message>
        <source>No servo answered. Check supply and leads, and try --bauds all.</source>
        <translation>没有舵机应答。请检查供电和接线，并用 --bauds all 再试。</translation>
    </message>
    <message>
        <source>Something unreadable was heard where no servo could be proven: another baud rate, two servos with one ID, or noise.</source>
        <translation>收到无法识别的信号，但不能确认有舵机：波特率不同、ID 重复，或有干扰。</translation>
    </message>
    <message>
        <source>Several servos answered late, so others may have been missed: try again with --slow.</source>
        <translation>有几个舵机应答偏晚，可能漏掉了别的：请加 --slow 再搜索一次。</translation>
    </message>
    <message>
        <source>This adapter cannot run at %1 baud.</source>
        <translation>此适配器不支持波特率 %1。</translation>
    </message>
    <message>
        <source>Stopped before the end.</source>
        <translation>中途停止。</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>正在搜索</translation>
    </message>
    <message>
        <source>Found on %1: %2, in %3 s</source>
        <translation>在 %1 上找到 %2 个，用时 %3 秒</translation>
    </message>
    <message>
        <source>search the bus; writes nothing</source>
        <translation>搜索总线；不写入任何内容</translation>
    </message>
    <message>
        <source>only these IDs (usual: 0-253)</source>
        <translation>只搜索这些 ID（默认 0-253）</translation>
    </message>
    <message>
        <source>baud rates to search at</source>
        <translation>搜索用的波特率</translation>
    </message>
    <message>
        <source>ask silent IDs again, with long patience</source>
        <translation>对没有应答的 ID 用较长超时再问一次</translation>
    </message>
    <message>
        <source>Servo %1, %2: registers saved to %3: %4</source>
        <translation>舵机 %1，%2：保存到 %3 的寄存器数：%4</translation>
    </message>
    <message>
        <source>Addr</source>
        <translation>地址</translation>
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
        <translation>存储区域</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>读写</translation>
    </message>
    <message>
        <source>Servo %1: %2 (%3), firmware %4, on %5 at %6</source>
        <translation>舵机 %1：%2（%3），固件 %4，端口 %5，时间 %6</translation>
    </message>
    <message>
        <source>save all registers of a servo to a file</source>
        <translation>把舵机的全部寄存器保存到文件</translation>
    </message>
    <message>
        <source>usually NAME.servo.json; replaced if it exists</source>
        <translation>一般为 NAME.servo.json；已存在则覆盖</translation>
    </message>
    <message>
        <source>show a saved file; needs no port</source>
        <translation>显示已保存的文件；不需要端口</translation>
    </message>
    <message>
        <source>a file made by snapshot save</source>
        <translation>由 snapshot save 保存的文件</translation>
    </message>
    <message>
        <source>torque on</source>
        <translation>扭矩已打开</translation>
    </message>
    <message>
        <source>torque off</source>
        <translation>扭矩已关闭</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>阻尼</translation>
    </message>
    <message>
        <source>the last word must be on, off or damp</source>
        <translation>最后一个词应为 on（打开）、off（关闭）或 damp（阻尼）</translation>
    </message>
    <message>
        <source>no mode &quot;%1&quot;; it has %2</source>
        <translation>没有模式 “%1”；可用的有 %2</translation>
    </message>
    <message>
        <source>servos (1 2 3, 1-6, 1,3), then what to do</source>
        <translation>舵机（1 2 3、1-6、1,3），最后是要做的操作</translation>
    </message>
    <message>
        <source>switch the operating mode; torque stays off afterwards</source>
        <translation>切换运行模式；切换后扭矩保持关闭</translation>
    </message>
    <message>
        <source>the tour writes and moves, so it only runs on a simulated bus: --port sim:demo</source>
        <translation>演示会写入参数并转动舵机，只能在仿真总线上运行：--port sim:demo</translation>
    </message>
    <message>
        <source>a guided tour on a simulated bus; no servo is needed</source>
        <translation>在仿真总线上的功能演示；不需要舵机</translation>
    </message>
    <message>
        <source>Readings: %1 in %2 s; missed: %3</source>
        <translation>读取 %1 次，用时 %2 秒；缺失 %3 次</translation>
    </message>
    <message>
        <source>read the feedback of servos again and again</source>
        <translation>连续读取舵机反馈</translation>
    </message>
    <message>
        <source>servos: 1 2 3, 1-6, 1,3</source>
        <translation>舵机：1 2 3、1-6、1,3</translation>
    </message>
    <message>
        <source>readings a second and servo (usual: 20)</source>
        <translation>每个舵机每秒读取次数（默认 20）</translation>
    </message>
    <message>
        <source>end after so many seconds (else with Ctrl-C)</source>
        <translation>多少秒后结束（否则按 Ctrl-C 结束）</translation>
    </message>
    <message>
        <source>write the readings to a file</source>
        <translation>把读数写入文件</translation>
    </message>
    <message>
        <source>change registers safely: record, unlock, write, read back, lock</source>
        <translation>安全修改寄存器：记录、解锁、写入、回读、上锁</translation>
    </message>
    <message>
        <source>value raw (85), physical with its unit (8.5V, 90deg) or by name (position)</source>
        <translation>数值可写原始值（85）、带单位的物理值（8.5V、90deg）或名称（position）</translation>
    </message>
    <message>
        <source>keep the lock closed: lost at power-off</source>
        <translation>不解锁：断电后恢复原值</translation>
    </message>
    <message>
        <source>yes, also registers that can make the servo unreachable or turn the other way</source>
        <translation>确认也写可能使舵机失联或反转的寄存器</translation>
    </message>
    <message>
        <source>Finds, reads, changes and drives serial bus servos.</source>
        <translation>搜索、读取、修改和驱动串行总线舵机。</translation>
    </message>
    <message>
        <source>Usage: servodesk-cli [OPTIONS] COMMAND …</source>
        <translation>用法：servodesk-cli [选项] 命令 …</translation>
    </message>
    <message>
        <source>Commands:</source>
        <translation>命令：</translation>
    </message>
    <message>
        <source>Usage: servodesk-cli [OPTIONS] %1</source>
        <translation>用法：servodesk-cli [选项] %1</translation>
    </message>
    <message>
        <source>Options of this command:</source>
        <translation>此命令的选项：</translation>
    </message>
    <message>
        <source>Options:</source>
        <translation>选项：</translation>
    </message>
    <message>
        <source>Exit codes: 0 done, 1 the servo did not do it, 2 usage, 3 port, 4 no answer, 5 file.
&quot;servodesk-cli COMMAND --help&quot; tells more about a command.</source>
        <translation>退出码：0 完成，1 舵机未执行，2 用法错误，3 端口，4 无应答，5 文件。
“servodesk-cli 命令 --help” 显示该命令的详细说明。</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>缺少 %1</translation>
    </message>
    <message>
        <source>there is no command &quot;%1&quot;; did you mean %2?</source>
        <translation>没有命令 “%1”；是不是 %2？</translation>
    </message>
    <message>
        <source>there is no command &quot;%1&quot;</source>
        <translation>没有命令 “%1”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not understood here</source>
        <translation>这里不能识别 “%1”</translation>
    </message>
    <message>
        <source>say which command; --help lists them</source>
        <translation>请给出命令；--help 列出全部命令</translation>
    </message>
    <message>
        <source>an option lacks its value, or is given twice (%1)</source>
        <translation>选项缺少数值，或重复给出（%1）</translation>
    </message>
    <message>
        <source>patience with a silent servo beyond the wire time (usual: 25, growing)</source>
        <translation>除传输时间外的应答超时，毫秒（默认 25，可自动加长）</translation>
    </message>
    <message>
        <source>how often a disturbed request is repeated</source>
        <translation>通信受干扰时的重试次数</translation>
    </message>
    <message>
        <source>print one JSON document</source>
        <translation>输出一个 JSON 文档</translation>
    </message>
    <message>
        <source>language of the words</source>
        <translation>文字的语言</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no language of this program (en, zh_CN)</source>
        <translation>本程序没有语言 “%1”（en、zh_CN）</translation>
    </message>
    <message>
        <source>The result could not be written: %1</source>
        <translation>结果无法写出：%1</translation>
    </message>
    <message>
        <source>%1 %, about %2 s left</source>
        <translation>%1 %，约剩 %2 秒</translation>
    </message>
    <message>
        <source>a raw number from %1 to %2</source>
        <translation>%1 到 %2 的原始值</translation>
    </message>
    <message>
        <source>a raw number</source>
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
        <source>&quot;%1&quot;; expected is %2</source>
        <translation>“%1”；应为%2</translation>
    </message>
    <message>
        <source>%1 (%2), firmware %3</source>
        <translation>%1（%2），固件 %3</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>内存</translation>
    </message>
    <message>
        <source>Old</source>
        <translation>旧值</translation>
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
        <source>Outcome</source>
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
        <source>  Try: %1</source>
        <translation>  可试：%1</translation>
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
        <source>no adapter is plugged in; choose with --port: %1</source>
        <translation>没有插入适配器；请用 --port 选择：%1</translation>
    </message>
    <message>
        <source>there are several adapters; choose with --port: %1</source>
        <translation>有多个适配器；请用 --port 选择：%1</translation>
    </message>
    <message>
        <source>SIMULATED bus %1</source>
        <translation>仿真总线 %1</translation>
    </message>
    <message>
        <source>Servo %1 answers at %2 baud.</source>
        <translation>舵机 %1 在波特率 %2 下应答。</translation>
    </message>
    <message>
        <source>at none of the known baud rates</source>
        <translation>已知的波特率都试过了</translation>
    </message>
    <message>
        <source>Servo %1: %2</source>
        <comment>notice</comment>
        <translation>舵机 %1：%2</translation>
    </message>
    <message>
        <source>
In all: servos found: %1; requests: %2, answered: %3, repeated: %4; half of the answers took less than %5 ms.</source>
        <translation>
总计：找到舵机 %1 个；请求 %2 次，应答 %3 次，重试 %4 次；半数应答用时不到 %5 毫秒。</translation>
    </message>
    <message>
        <source>Servo %1 has the settings it had before.</source>
        <translation>舵机 %1 的参数与演示前相同。</translation>
    </message>
    <message>
        <source>Servo %1 differs from before in: %2</source>
        <translation>舵机 %1 与演示前不同的参数：%2</translation>
    </message>
    <message>
        <source>Next: &quot;servodesk-cli ports&quot; lists your adapters, &quot;servodesk-cli --port PORT scan&quot; finds your servos.</source>
        <translation>接下来：“servodesk-cli ports” 列出适配器，“servodesk-cli --port 端口 scan” 搜索您的舵机。</translation>
    </message>
    <message>
        <source>Change two values: one to be kept, one for this power-on only</source>
        <translation>修改两个数值：一个永久保存，一个只在本次上电有效</translation>
    </message>
    <message>
        <source>What that was on the wire: settings read, lock opened, written, read back, lock closed and proven.</source>
        <translation>线路上的过程：读参数、解锁、写入、回读、上锁并确认。</translation>
    </message>
    <message>
        <source>Switch all servos off and on again</source>
        <translation>所有舵机断电再上电</translation>
    </message>
    <message>
        <source>After power-off</source>
        <translation>断电之后</translation>
    </message>
    <message>
        <source>So it was</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>已恢复原值</translation>
    </message>
    <message>
        <source>Put the old value back</source>
        <translation>恢复旧值</translation>
    </message>
    <message>
        <source>Search the bus: a PING to each of 254 IDs; nothing is written</source>
        <translation>搜索总线：向 254 个 ID 逐个发送 PING；不写入任何内容</translation>
    </message>
    <message>
        <source>Found: %1, in %2 s</source>
        <translation>找到 %1 个，用时 %2 秒</translation>
    </message>
    <message>
        <source>no healthy servo in position mode on this bus</source>
        <translation>此总线上没有处于位置模式且无报警的舵机</translation>
    </message>
    <message>
        <source>The memory table of servo %1, %2 (some of its rows)</source>
        <translation>舵机 %1 的内存表，%2（部分）</translation>
    </message>
    <message>
        <source>Registers in the table: %1</source>
        <translation>内存表中的寄存器：%1 个</translation>
    </message>
    <message>
        <source>A snapshot before anything is changed</source>
        <translation>修改之前先保存一份参数备份</translation>
    </message>
    <message>
        <source>Registers saved: %1, in %2</source>
        <translation>已保存 %1 个寄存器，文件 %2</translation>
    </message>
    <message>
        <source>Alarms, and what releases them</source>
        <translation>报警及解除方法</translation>
    </message>
    <message>
        <source>No servo reports an alarm.</source>
        <translation>没有舵机报警。</translation>
    </message>
    <message>
        <source>Goal %1, arrived at %2 after %3 s</source>
        <translation>目标 %1，用时 %3 秒到达 %2</translation>
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
        <source>no answer</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>The EPROM lock is open; to close it: servodesk-cli write %1 lock=1</source>
        <translation>EPROM 没有上锁；上锁命令：servodesk-cli write %1 lock=1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no protocol (auto, feetech, modbus, lx)</source>
        <translation>“%1” 不是协议（auto、feetech、modbus、lx）</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>修改编号</translation>
    </message>
    <message>
        <source>Nothing was written. --finish completes what was begun, --undo puts the old values back, --forget gives up a change whose servo will not come back.</source>
        <translation>未写入任何内容。--finish 完成已开始的修改，--undo 恢复旧值，--forget 放弃已不再使用的舵机的修改。</translation>
    </message>
    <message>
        <source>there is no open change &quot;%1&quot;</source>
        <translation>没有未完成的修改 “%1”</translation>
    </message>
    <message>
        <source>Changes given up: %1</source>
        <translation>已放弃的修改：%1 个</translation>
    </message>
    <message>
        <source>give up a change whose servo will not come back (the first letters of its name will do)</source>
        <translation>放弃已不再使用的舵机的修改（写出编号开头几位即可）</translation>
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
        <source>position, multiturn, speed, pwm, step, current or motor, as the family has them</source>
        <translation>position（位置）、multiturn（多圈）、speed（恒速）、pwm、step（步进）、current（恒流）或 motor（电机），视系列而定</translation>
    </message>
    <message>
        <source>device path, tcp://HOST:PORT, or a simulated bus: sim:demo, sim:trouble, sim:modbus, sim:lx, sim:sts3215@1,lx16a@2 (starts anew with each run)</source>
        <translation>设备路径、tcp://主机:端口，或仿真总线：sim:demo、sim:trouble、sim:modbus、sim:lx、sim:sts3215@1,lx16a@2（每次运行重新开始）</translation>
    </message>
    <message>
        <source>baud rate, or auto to try all (usual: 1000000; 115200 for LX and Modbus)</source>
        <translation>波特率，auto 为逐个尝试（默认 1000000；LX 和 Modbus 为 115200）</translation>
    </message>
    <message>
        <source>silence between Modbus frames (usual: 1750 above 19200 baud, as the standard says)</source>
        <translation>Modbus 帧间静默时间，微秒（默认按标准：19200 以上为 1750）</translation>
    </message>
    <message>
        <source>, %1 at %2 baud, found: %3</source>
        <translation>，%1，波特率 %2，已找到 %3 个</translation>
    </message>
    <message>
        <source>Searched at %1 baud. At 1000000 baud there are Feetech servos only; LX, Modbus and most SMS servos are at 115200.</source>
        <translation>已搜索的波特率：%1。1000000 下只有飞特舵机；LX、Modbus 和多数 SMS 舵机为 115200。</translation>
    </message>
    <message>
        <source>what the servos speak: auto, feetech, modbus or lx (usual: auto, all that can exist at the rate)</source>
        <translation>舵机使用的协议：auto、feetech、modbus 或 lx（默认 auto：该波特率下可能存在的全部协议）</translation>
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
        <source>Nothing was written. Keep clear of the mechanism and repeat it with --move.</source>
        <translation>没有写入任何内容。请避开机构，再加 --move 重新执行。</translation>
    </message>
    <message>
        <source>The alarm is gone.</source>
        <translation>报警已解除。</translation>
    </message>
    <message>
        <source>show what keeps an alarm alive, and clear it by its cause</source>
        <translation>显示报警的原因，并按原因清除</translation>
    </message>
    <message>
        <source>agree that the servo turns a little, or that its torque is switched on</source>
        <translation>同意舵机转动一点，或打开扭矩</translation>
    </message>
    <message>
        <source>The LED of servo %1 blinks; Ctrl-C ends it.</source>
        <translation>舵机 %1 的 LED 正在闪烁；按 Ctrl-C 结束。</translation>
    </message>
    <message>
        <source>The LED of servo %1 is as it was before.</source>
        <translation>舵机 %1 的 LED 设置已恢复原样。</translation>
    </message>
    <message>
        <source>make a servo blink its LED for a few seconds</source>
        <translation>让舵机的 LED 闪烁几秒</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>项目</translation>
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
        <translation>往返测试</translation>
    </message>
    <message>
        <source>on the way to the start, or warming up</source>
        <translation>正在前往起点或预热</translation>
    </message>
    <message>
        <source>cycle %1, %2 %, about %3 s left</source>
        <translation>第 %1 个循环，%2 %，约剩 %3 秒</translation>
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
        <source>move servos to and fro, measure and judge them</source>
        <translation>让舵机往返运动，测量并判定</translation>
    </message>
    <message>
        <source>--step, --both-sides, --random, --sine and --points exclude each other</source>
        <translation>--step、--both-sides、--random、--sine 和 --points 只能用一个</translation>
    </message>
    <message>
        <source>with --points there is no --from and no --to</source>
        <translation>使用 --points 时不能用 --from 和 --to</translation>
    </message>
    <message>
        <source>--from and --to are needed</source>
        <translation>需要 --from 和 --to</translation>
    </message>
    <message>
        <source>--delay and --dwell exclude each other</source>
        <translation>--delay 和 --dwell 只能用一个</translation>
    </message>
    <message>
        <source>--delay or --dwell is needed</source>
        <translation>需要 --delay 或 --dwell</translation>
    </message>
    <message>
        <source>start: raw, or with its unit (90deg)</source>
        <translation>起点：原始值，或带单位（90deg）</translation>
    </message>
    <message>
        <source>end: raw, or with its unit</source>
        <translation>终点：原始值，或带单位</translation>
    </message>
    <message>
        <source>from one goal to the next, arrived or not</source>
        <translation>延时：从一个目标到下一个目标，不管是否到位</translation>
    </message>
    <message>
        <source>rest after arrival instead</source>
        <translation>改为到位后停留的时间</translation>
    </message>
    <message>
        <source>there and back so many times (usual: 10)</source>
        <translation>往返次数（默认 10）</translation>
    </message>
    <message>
        <source>end after so many seconds</source>
        <translation>到这么多秒后结束</translation>
    </message>
    <message>
        <source>go in steps of this size, up and down</source>
        <translation>按此步长逐步往返</translation>
    </message>
    <message>
        <source>come to the middle from both sides too</source>
        <translation>还从两侧到达中点</translation>
    </message>
    <message>
        <source>random targets, the same for the same number</source>
        <translation>随机目标，种子相同则目标相同</translation>
    </message>
    <message>
        <source>follow a sine with this period</source>
        <translation>按此周期跟随正弦</translation>
    </message>
    <message>
        <source>targets from a CSV file: target,pause in ms</source>
        <translation>从 CSV 文件读目标：目标,停留毫秒数</translation>
    </message>
    <message>
        <source>travel time in milliseconds (SCS, LX)</source>
        <translation>运行时间，毫秒（SCS、LX）</translation>
    </message>
    <message>
        <source>move for so many seconds before measuring</source>
        <translation>测量前先预热这么多秒</translation>
    </message>
    <message>
        <source>torque off at the end (usual: hold)</source>
        <translation>结束时卸力（默认保持）</translation>
    </message>
    <message>
        <source>end with the first limit that is failed</source>
        <translation>出现第一个不合格项时结束</translation>
    </message>
    <message>
        <source>limits to judge by (usual: the built-in ones)</source>
        <translation>判定用的限值（默认用内置的）</translation>
    </message>
    <message>
        <source>write the report; the readings go to a CSV beside it</source>
        <translation>写报告；采样数据写到旁边的 CSV</translation>
    </message>
    <message>
        <source>who tests, for the report</source>
        <translation>测试人，写入报告</translation>
    </message>
    <message>
        <source>a remark for the report</source>
        <translation>备注，写入报告</translation>
    </message>
    <message>
        <source>a report ends with .html, .pdf, .json or .csv</source>
        <translation>报告文件名以 .html、.pdf、.json 或 .csv 结尾</translation>
    </message>
    <message>
        <source>a report ends with .html, .json or .csv</source>
        <translation>报告文件须以 .html、.json 或 .csv 结尾</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>--size is needed</source>
        <translation>缺少 --size</translation>
    </message>
    <message>
        <source>%1 cannot be tried; this servo has %2</source>
        <translation>%1 不能试用；该舵机可用：%2</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>阶跃响应</translation>
    </message>
    <message>
        <source>Step response, trial</source>
        <translation>阶跃响应（试用）</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>The trial is over: the servo has its own values again, unless a note says otherwise. &quot;write&quot; keeps what proved good.</source>
        <translation>试用已结束：除非另有说明，舵机已恢复原值。效果好的值请用 write 保存。</translation>
    </message>
    <message>
        <source>Report: %1</source>
        <translation>报告：%1</translation>
    </message>
    <message>
        <source>measure how a servo answers a step, before and after a change of its gains</source>
        <translation>测量舵机的阶跃响应，可对比修改增益前后</translation>
    </message>
    <message>
        <source>how far: raw, or with its unit (30deg)</source>
        <translation>阶跃大小：原始值，或带单位（30deg）</translation>
    </message>
    <message>
        <source>start (usual: where it stands, if there is room)</source>
        <translation>起点（通常为当前位置，若空间足够）</translation>
    </message>
    <message>
        <source>there and back so many times (usual: 3)</source>
        <translation>往返次数（通常为 3）</translation>
    </message>
    <message>
        <source>from one goal to the next (usual: as it needs)</source>
        <translation>目标间隔（通常自动确定）</translation>
    </message>
    <message>
        <source>raw or with its unit (usual: as fast as it can)</source>
        <translation>原始值或带单位（通常为最快）</translation>
    </message>
    <message>
        <source>a second run with these values, which are put back afterwards: position_p=40,position_d=20</source>
        <translation>用这些值再运行一次，结束后恢复：position_p=40,position_d=20</translation>
    </message>
    <message>
        <source>a servo in another mode is in position mode while the test lasts, and back afterwards</source>
        <translation>处于其他模式的舵机在测试期间切换到位置模式，结束后切换回来</translation>
    </message>
    <message>
        <source>write the runs to a file</source>
        <translation>将运行结果写入文件</translation>
    </message>
    <message>
        <source>the report of a comparison ends with .html</source>
        <translation>对比报告的文件名须以 .html 结尾</translation>
    </message>
    <message>
        <source>hold one sweep test against another; needs no port</source>
        <translation>对比两次扫描测试；不需要端口</translation>
    </message>
    <message>
        <source>a test run: 12 of the history, 12:3 for servo 3 of it, or a report that ends with .json</source>
        <translation>测试记录：历史中的 12，其中舵机 3 写作 12:3，或以 .json 结尾的报告</translation>
    </message>
    <message>
        <source>the one that is held against it</source>
        <translation>与之对比的测试</translation>
    </message>
    <message>
        <source>which servo, where a run has several</source>
        <translation>记录含多个舵机时选哪一个</translation>
    </message>
    <message>
        <source>save the comparison as a page (.html)</source>
        <translation>将对比保存为网页（.html）</translation>
    </message>
    <message>
        <source>make a report of an earlier sweep test; needs no port</source>
        <translation>生成以前扫描测试的报告；不需要端口</translation>
    </message>
    <message>
        <source>number in the history, or a report that ends with .json</source>
        <translation>历史中的编号，或以 .json 结尾的报告</translation>
    </message>
    <message>
        <source>by its ending: .html, .pdf, .json or .csv</source>
        <translation>按扩展名：.html、.pdf、.json 或 .csv</translation>
    </message>
    <message>
        <source>No test run fits.</source>
        <translation>没有符合条件的测试记录。</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>记录</translation>
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
        <source>a reference is a test run of the history: 12, or 12:3 for servo 3 of it</source>
        <translation>参考须为历史中的测试记录：12，或 12:3（其中的舵机 3）</translation>
    </message>
    <message>
        <source>Test run %1, servo %2, is now the reference of %3</source>
        <translation>测试记录 %1 的舵机 %2 现为 %3 的参考</translation>
    </message>
    <message>
        <source>Test run %1, servo %2, is no reference of %3</source>
        <translation>测试记录 %1 的舵机 %2 不是 %3 的参考</translation>
    </message>
    <message>
        <source>list the sweep tests of the history; needs no port</source>
        <translation>列出历史中的扫描测试；不需要端口</translation>
    </message>
    <message>
        <source>only servos of this model</source>
        <translation>仅此型号的舵机</translation>
    </message>
    <message>
        <source>only with this ID</source>
        <translation>仅此 ID</translation>
    </message>
    <message>
        <source>only with this in label, note, operator or port</source>
        <translation>仅标签、备注、操作员或端口含此文字的</translation>
    </message>
    <message>
        <source>make a servo of a test run the reference of its model</source>
        <translation>将测试记录中的舵机设为其型号的参考</translation>
    </message>
    <message>
        <source>number in the history: 12, or 12:3 for servo 3</source>
        <translation>历史中的编号：12，或 12:3（舵机 3）</translation>
    </message>
    <message>
        <source>it is one no longer</source>
        <translation>取消参考</translation>
    </message>
    <message>
        <source>Kept in the history as test run %1</source>
        <translation>已存入历史，测试记录 %1</translation>
    </message>
    <message>
        <source>It was left in %1 instead</source>
        <translation>已改存到 %1</translation>
    </message>
    <message>
        <source>there is no test run %1 in the history; sweep-runs lists them</source>
        <translation>历史中没有测试记录 %1；sweep-runs 可列出全部</translation>
    </message>
    <message>
        <source>%1 has no servo %2</source>
        <translation>%1 中没有舵机 %2</translation>
    </message>
    <message>
        <source>%1 has servos %2; say which, as in %1:%3 or with --servo</source>
        <translation>%1 含舵机 %2；请指明是哪一个，如 %1:%3 或用 --servo</translation>
    </message>
    <message>
        <source>Servo %1: the sine is faster than it can turn; its period needs %2 ms.</source>
        <translation>舵机 %1：正弦变化快于它能转的速度，周期需要 %2 毫秒。</translation>
    </message>
    <message>
        <source>Servo %1: the delay is shorter than the longest way takes, so it turns round before it arrives; %2 ms are enough.</source>
        <translation>舵机 %1：延时短于最长行程所需时间，未到达就会折返；%2 毫秒足够。</translation>
    </message>
    <message>
        <source>save all servos of the bus to one file</source>
        <translation>把总线上所有舵机保存到一个文件</translation>
    </message>
    <message>
        <source>usually NAME.bundle.json; replaced if it exists</source>
        <translation>通常为 NAME.bundle.json；已存在则替换</translation>
    </message>
    <message>
        <source>only these: 1, 1-6 or 1,3,5</source>
        <translation>仅限这些：1、1-6 或 1,3,5</translation>
    </message>
    <message>
        <source>a name for it</source>
        <translation>它的名称</translation>
    </message>
    <message>
        <source>a remark</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>write a saved bus back, each servo by its ID</source>
        <translation>把保存的总线写回，每台舵机按其 ID</translation>
    </message>
    <message>
        <source>a file made by bundle save</source>
        <translation>由 bundle save 生成的文件</translation>
    </message>
    <message>
        <source>also where another model has the ID now</source>
        <translation>即使现在该 ID 是另一型号</translation>
    </message>
    <message>
        <source>give --first-id or --id-list, not both</source>
        <translation>--first-id 与 --id-list 只能给一个</translation>
    </message>
    <message>
        <source>name the file of the batch with --batch FILE.csv</source>
        <translation>请用 --batch FILE.csv 指定批次文件</translation>
    </message>
    <message>
        <source>%1, ID %2 at %3 baud, gets ID %4.</source>
        <translation>%1，ID %2，波特率 %3，将设为 ID %4。</translation>
    </message>
    <message>
        <source>Beware: %1.</source>
        <translation>注意：%1。</translation>
    </message>
    <message>
        <source>Enter: go on; a and Enter: set it aside.</source>
        <translation>回车：继续；a 加回车：剔除。</translation>
    </message>
    <message>
        <source>The servo went away in the middle; plug it in again (ID %1).</source>
        <translation>舵机中途断开；请重新接上（ID %1）。</translation>
    </message>
    <message>
        <source>No ID is left; an unfinished servo is awaited.</source>
        <translation>ID 已用完；等待未完成的舵机。</translation>
    </message>
    <message>
        <source>Connect the next servo (it gets ID %1).</source>
        <translation>请接上下一个舵机（将设为 ID %1）。</translation>
    </message>
    <message>
        <source>Several servos answer; leave one: nothing is written.</source>
        <translation>有多个舵机应答，请只留一个：未写入任何内容。</translation>
    </message>
    <message>
        <source>Two servos answer under ID %1; leave one: nothing is written.</source>
        <translation>两个舵机都以 ID %1 应答，请只留一个：未写入任何内容。</translation>
    </message>
    <message>
        <source>Somebody answers, but cannot be recognised.</source>
        <translation>有应答，但无法识别。</translation>
    </message>
    <message>
        <source>Unplug it.</source>
        <translation>请拔下。</translation>
    </message>
    <message>
        <source>Unplug: ID %1 is done.</source>
        <translation>请拔下：ID %1 已完成。</translation>
    </message>
    <message>
        <source>%1 set up, %2 failed, %3 set aside; %4 unfinished. Batch: %5</source>
        <translation>完成 %1，失败 %2，剔除 %3；未完成 %4。批次：%5</translation>
    </message>
    <message>
        <source>All IDs have been given.</source>
        <translation>ID 已全部分配。</translation>
    </message>
    <message>
        <source>set up servos plugged in one after the other: template, ID, rate</source>
        <translation>逐个设置依次接上的舵机：模板、ID、波特率</translation>
    </message>
    <message>
        <source>the list of the batch; one that exists is gone on with</source>
        <translation>批次清单；已有的文件将继续</translation>
    </message>
    <message>
        <source>the first ID to give (usual: 1)</source>
        <translation>起始 ID（默认 1）</translation>
    </message>
    <message>
        <source>the IDs to give, in this order: 4-9,12</source>
        <translation>按此顺序分配的 ID：4-9,12</translation>
    </message>
    <message>
        <source>end after so many servos of the batch</source>
        <translation>批次达到此数量后结束</translation>
    </message>
    <message>
        <source>the rate to give (else each keeps its own)</source>
        <translation>要写入的波特率（否则保持不变）</translation>
    </message>
    <message>
        <source>a snapshot or template to write</source>
        <translation>要写入的快照或模板</translation>
    </message>
    <message>
        <source>also write its dangerous rows</source>
        <translation>也写入其中的危险项</translation>
    </message>
    <message>
        <source>set up each servo without asking; what has an alarm or does not fit is set aside</source>
        <translation>自动设置，不逐个确认；有报警或不符的舵机会被剔除</translation>
    </message>
    <message>
        <source>text of the labels, with {model} {id} {rate} {baud} {firmware} {date} {was_id}</source>
        <translation>标签文字，可含 {model} {id} {rate} {baud} {firmware} {date} {was_id}</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前值</translation>
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
        <translation>寄存器</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>快照</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>保存原因</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>寄存器数</translation>
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
        <source>on request</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>Gone</source>
        <translation>消失</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>正在记录</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Nothing in the history fits.</source>
        <translation>历史中没有符合的内容。</translation>
    </message>
    <message>
        <source>Servos carry no serial number: those alike in model, firmware, ID and label are one here.</source>
        <translation>舵机没有序列号：型号、固件、ID 和标签都相同的，在这里算作同一个。</translation>
    </message>
    <message>
        <source>--kind is writes, snapshots, alarms, recordings, runs, servos or, of a server, benches</source>
        <translation>--kind 可为 writes、snapshots、alarms、recordings、runs、servos;查看服务器时还可为 benches</translation>
    </message>
    <message>
        <source>Rows written to %1: %2</source>
        <translation>写入 %1 的行数：%2</translation>
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
        <source>give --csv or --export, not both</source>
        <translation>--csv 和 --export 只能给一个</translation>
    </message>
    <message>
        <source>there is no history yet</source>
        <translation>还没有历史</translation>
    </message>
    <message>
        <source>writes (usual), snapshots, alarms, recordings, runs, servos; of a server also benches</source>
        <translation>writes(默认)、snapshots、alarms、recordings、runs、servos;服务器还可用 benches</translation>
    </message>
    <message>
        <source>all that fits to a CSV file instead</source>
        <translation>改为把所有符合的写入 CSV 文件</translation>
    </message>
    <message>
        <source>all that fits to a JSON file instead</source>
        <translation>改为把所有符合的写入 JSON 文件</translation>
    </message>
    <message>
        <source>list what was written to servos and happened to them; needs no port</source>
        <translation>列出对舵机的写入及其经历；不需要端口</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number of a row</source>
        <translation>“%1”不是行的编号</translation>
    </message>
    <message>
        <source>%1, servo %2 %3, on %4 at %5 baud, by %6</source>
        <translation>%1，舵机 %2 %3，端口 %4，波特率 %5，程序 %6</translation>
    </message>
    <message>
        <source>an earlier version</source>
        <translation>较早的版本</translation>
    </message>
    <message>
        <source>The %1 that answers to ID %2 is now servo %3, &quot;%4&quot;</source>
        <translation>应答 ID %2 的 %1 现在是舵机 %3，“%4”</translation>
    </message>
    <message>
        <source>The %1 with ID %2, servo %3, is called &quot;%4&quot;</source>
        <translation>ID %2 的 %1（舵机 %3）名为“%4”</translation>
    </message>
    <message>
        <source>Registers saved to %1: %2</source>
        <translation>保存到 %1 的寄存器数：%2</translation>
    </message>
    <message>
        <source>From snapshot %1 of %2; written since then: %3</source>
        <translation>来自快照 %1（%2）；此后写入：%3</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Changed without a record of how, so without a value: %1</source>
        <translation>以未被记录的方式改变，因此没有值：%1</translation>
    </message>
    <message>
        <source>show a write with all that was written together with it</source>
        <translation>显示一次写入以及同时写入的全部内容</translation>
    </message>
    <message>
        <source>its number in &quot;history&quot;</source>
        <translation>它在 &quot;history&quot; 中的编号</translation>
    </message>
    <message>
        <source>give a servo of the history a name, as servos carry no serial number</source>
        <translation>给历史中的舵机起名，因为舵机没有序列号</translation>
    </message>
    <message>
        <source>its number in &quot;history --kind servos&quot;, or its label</source>
        <translation>它在 &quot;history --kind servos&quot; 中的编号，或它的标签</translation>
    </message>
    <message>
        <source>the name; &quot;&quot; takes it away</source>
        <translation>名称；&quot;&quot; 表示去掉</translation>
    </message>
    <message>
        <source>what answers like this from now on is another servo, the one with this label; the past stays with the former</source>
        <translation>从现在起这样应答的是另一个舵机，即带此标签的那个；过去的记录留给原来的舵机</translation>
    </message>
    <message>
        <source>take a snapshot out of the history again, as a file for snapshot restore</source>
        <translation>从历史中取出快照，存为供 snapshot restore 使用的文件</translation>
    </message>
    <message>
        <source>its number in &quot;history --kind snapshots&quot;</source>
        <translation>它在 &quot;history --kind snapshots&quot; 中的编号</translation>
    </message>
    <message>
        <source>a servo&apos;s table as it was at a moment, as a file for snapshot restore: the last snapshot before it and the writes since</source>
        <translation>某一时刻舵机的内存表，存为供 snapshot restore 使用的文件：此前最后一个快照加上此后的写入</translation>
    </message>
    <message>
        <source>2026-11-22T10:30, 10:30, or 90m, 2h, 3d, 1w ago</source>
        <translation>2026-11-22T10:30、10:30，或 90m、2h、3d、1w 之前</translation>
    </message>
    <message>
        <source>no history server is set; name one with --server or SERVODESK_HISTORY_SERVER</source>
        <translation>未设置历史服务器;请用 --server 或 SERVODESK_HISTORY_SERVER 指定</translation>
    </message>
    <message>
        <source>Rows sent to %1 as %2: %3; it has everything now</source>
        <translation>已以 %2 的名义向 %1 发送 %3 行;服务器数据已齐全</translation>
    </message>
    <message>
        <source>send what a history server (PostgreSQL) has missed; needs no port</source>
        <translation>向历史服务器(PostgreSQL)补发其缺少的数据;不需要端口</translation>
    </message>
    <message>
        <source>what this bench is called there</source>
        <translation>本工位在服务器上的名称</translation>
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
        <source>the name of this servo</source>
        <translation>这台舵机的名称</translation>
    </message>
    <message>
        <source>as CSV, for spreadsheets</source>
        <translation>以 CSV 输出，用于电子表格</translation>
    </message>
    <message>
        <source>&quot;default&quot; needs a servo, or a file of a known model, beside it</source>
        <translation>“default” 旁边需要有舵机，或已知型号的文件</translation>
    </message>
    <message>
        <source>Factory</source>
        <translation>出厂</translation>
    </message>
    <message>
        <source>%1 different, %2 missing, %3 unknown, %4 identical, %5 read-only</source>
        <translation>不同 %1，缺少 %2，未知 %3，相同 %4，只读 %5</translation>
    </message>
    <message>
        <source>give at least two of: a file, an ID, default</source>
        <translation>至少给出两项：文件、ID 或 default</translation>
    </message>
    <message>
        <source>compare tables side by side: files, servos, factory default</source>
        <translation>并排比较参数表：文件、舵机、出厂默认值</translation>
    </message>
    <message>
        <source>two or more: a file, an ID (the servo is read), or default; ./5 is a file called 5</source>
        <translation>两项或更多：文件、ID（读取该舵机）或 default；./5 表示名为 5 的文件</translation>
    </message>
    <message>
        <source>also rows that are identical, unknown or read-only</source>
        <translation>也显示相同、未知或只读的行</translation>
    </message>
    <message>
        <source>The result is in %1</source>
        <translation>结果保存在 %1</translation>
    </message>
    <message>
        <source>write a saved file back to a servo: only what differs, torque off first, each row read back</source>
        <translation>把保存的文件写回舵机：只写不同的行，先关闭扭矩，每行回读</translation>
    </message>
    <message>
        <source>a snapshot or template, also of another servo</source>
        <translation>快照或模板，也可来自另一台舵机</translation>
    </message>
    <message>
        <source>also ID and baud rate, at the very end</source>
        <translation>也包括 ID 和波特率，放在最后</translation>
    </message>
    <message>
        <source>%1 makes a servo this servo; a template has it only with --identity</source>
        <translation>%1 决定舵机的身份；模板仅在使用 --identity 时包含它</translation>
    </message>
    <message>
        <source>%1 can only be read</source>
        <translation>%1 只读</translation>
    </message>
    <message>
        <source>%1 has no value there</source>
        <translation>%1 在那里没有值</translation>
    </message>
    <message>
        <source>save chosen registers for giving them to other servos</source>
        <translation>保存选定的寄存器，用于写给其他舵机</translation>
    </message>
    <message>
        <source>a snapshot file, or an ID (the servo is read)</source>
        <translation>快照文件，或 ID（读取该舵机）</translation>
    </message>
    <message>
        <source>the registers</source>
        <translation>寄存器</translation>
    </message>
    <message>
        <source>ID and baud rate may be among them</source>
        <translation>其中可以有 ID 和波特率</translation>
    </message>
    <message>
        <source>write a template or snapshot to several servos, one verdict each; never ID or baud rate</source>
        <translation>把模板或快照写给多台舵机，每台给出结论；从不写 ID 或波特率</translation>
    </message>
    <message>
        <source>a template or snapshot</source>
        <translation>模板或快照</translation>
    </message>
    <message>
        <source>the servos: 1, 1-6 or 1,3,5</source>
        <translation>舵机：1、1-6 或 1,3,5</translation>
    </message>
    <message>
        <source>only this one: its number in &quot;history --kind servos&quot;, or its label</source>
        <translation>只要这一个：它在 &quot;history --kind servos&quot; 中的编号，或它的标签</translation>
    </message>
    <message>
        <source>only with this label</source>
        <translation>只要这个标签</translation>
    </message>
    <message>
        <source>only from then on: 2026-11-22, 2026-11-22T10:30, 10:30, or 90m, 2h, 3d, 1w ago</source>
        <translation>只要此后的：2026-11-22、2026-11-22T10:30、10:30，或 90m、2h、3d、1w 之前</translation>
    </message>
    <message>
        <source>only before then</source>
        <translation>只要此前的</translation>
    </message>
    <message>
        <source>only writes to this register</source>
        <translation>只要对这个寄存器的写入</translation>
    </message>
    <message>
        <source>only writes that did not end well, alarms that have not gone</source>
        <translation>只要没有成功的写入、尚未消失的报警</translation>
    </message>
    <message>
        <source>so many rows, the newest (usual: 200)</source>
        <translation>最新的若干行（通常 200 行）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no time: 2026-11-22, 2026-11-22T10:30, 10:30, or 90m, 2h, 3d, 1w ago</source>
        <translation>“%1”不是时间：请写 2026-11-22、2026-11-22T10:30、10:30，或 90m、2h、3d、1w 之前</translation>
    </message>
    <message>
        <source>the history knows no servo &quot;%1&quot;; &quot;history --kind servos&quot; lists them</source>
        <translation>历史中没有舵机“%1”；用 &quot;history --kind servos&quot; 列出</translation>
    </message>
    <message>
        <source>several servos have the label &quot;%1&quot;; give the number of one: &quot;history --kind servos&quot; lists them</source>
        <translation>有几个舵机的标签都是“%1”；请给出其中一个的编号：用 &quot;history --kind servos&quot; 列出</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>已撤销</translation>
    </message>
    <message>
        <source>no bench called %1 sends there; these do: %2</source>
        <translation>没有名为 %1 的工位向其发送数据;现有:%2</translation>
    </message>
    <message>
        <source>look at the copies on a history server: its connection string, or &quot;default&quot; for the one that is set</source>
        <translation>查看历史服务器上的副本:填连接字符串,或用 &quot;default&quot; 表示已设置的服务器</translation>
    </message>
    <message>
        <source>only what this bench has sent to the server</source>
        <translation>仅显示该工位发送到服务器的数据</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>未写入</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>The file is of another model: rows are matched by their key.</source>
        <translation>文件来自另一型号：按键名对应各行。</translation>
    </message>
    <message>
        <source>The file is of another firmware: rows are matched by their key.</source>
        <translation>文件来自另一固件：按键名对应各行。</translation>
    </message>
    <message>
        <source>%1, put back</source>
        <translation>%1，已退回</translation>
    </message>
    <message>
        <source>these registers only: KEY,KEY</source>
        <translation>仅限这些寄存器：KEY,KEY</translation>
    </message>
    <message>
        <source>also what is lost at power-off (acceleration, torque limit)</source>
        <translation>也包括掉电丢失的值（加速度、扭矩限制）</translation>
    </message>
    <message>
        <source>yes, also registers that can make the servo unreachable or turn it</source>
        <translation>同意，也包括可能使舵机失联或转动的寄存器</translation>
    </message>
    <message>
        <source>at the first failure put everything back; otherwise it stops there</source>
        <translation>首次失败时全部退回；否则就此停止</translation>
    </message>
    <message>
        <source>show the writes to come, write nothing</source>
        <translation>显示将要写入的内容，不写入</translation>
    </message>
    <message>
        <source>save what became of each row (.csv or .json)</source>
        <translation>保存每一行的结果（.csv 或 .json）</translation>
    </message>
    <message>
        <source>--only names no register</source>
        <translation>--only 没有指定寄存器</translation>
    </message>
    <message>
        <source>Nothing to write.</source>
        <translation>无需写入。</translation>
    </message>
    <message>
        <source>Will be</source>
        <translation>将变为</translation>
    </message>
    <message>
        <source>Nothing had to be written.</source>
        <translation>无需写入任何内容。</translation>
    </message>
    <message>
        <source>Result: %1</source>
        <translation>结果：%1</translation>
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
        <source>rows left out: %1</source>
        <translation>未写入的行：%1</translation>
    </message>
    <message>
        <source>The settings of servo %1 could not be saved first, so nothing is written to it.</source>
        <translation>未能先保存舵机 %1 的设置，因此不向它写入任何内容。</translation>
    </message>
    <message>
        <source>1 row was left out: %1</source>
        <translation>有 1 行未写入：%1</translation>
    </message>
    <message>
        <source>%1 rows were left out: %2</source>
        <translation>有 %1 行未写入：%2</translation>
    </message>
    <message>
        <source>Servos saved to %1: %2 (ID %3)</source>
        <translation>已保存到 %1 的舵机：%2 个（ID %3）</translation>
    </message>
    <message>
        <source>Nothing is done. Enter: go on; a and Enter: set it aside.</source>
        <translation>没有执行任何操作。回车：继续；a 加回车：剔除。</translation>
    </message>
    <message>
        <source>The alarms could not be kept in the history: %1 (%2)</source>
        <translation>报警未能存入历史：%1（%2）</translation>
    </message>
    <message>
        <source>its connection string, such as postgresql://USER@HOST/DATABASE, without a password (store it in ~/.pgpass); default: the one remembered. Another computer must have a valid TLS certificate, unless ?sslmode=... says otherwise</source>
        <translation>连接字符串，例如 postgresql://USER@HOST/DATABASE，不含密码（密码存放在 ~/.pgpass）；默认：已记住的那个。其他计算机上的服务器必须有有效的 TLS 证书，除非用 ?sslmode=... 另行指定</translation>
    </message>
    <message>
        <source>Limits of voltage, temperature, current and torque are left out; to write one of them, name it: --only KEY --dangerous.</source>
        <translation>电压、温度、电流和扭矩的限制不写入；如需写入其中一项，请指明名称：--only 名称 --dangerous。</translation>
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
        <source>ignored: did not finish</source>
        <translation>已忽略：未完成</translation>
    </message>
    <message>
        <source>--step &quot;%1&quot;: give a step above 0, raw (100) or with its unit (10deg); for the other direction swap --from and --to</source>
        <translation>--step “%1”：请给出大于 0 的步长，可为原始值（100）或带单位（10deg）；若要反方向，请对调 --from 和 --to</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;: give a whole number from %3 to %4</source>
        <translation>%1 “%2”：请给出 %3 到 %4 的整数</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;: give a number of seconds from %3 to %4</source>
        <translation>%1 “%2”：请给出 %3 到 %4 的秒数</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;: give 0 or more, raw or with its unit; the direction follows from the goals</source>
        <translation>%1 “%2”：请给出 0 或更大的值，可为原始值或带单位；方向由目标决定</translation>
    </message>
    <message>
        <source>family unclear: read only</source>
        <translation>系列不明：只读</translation>
    </message>
    <message>
        <source>On the command line the option %1 is your consent.</source>
        <translation>在命令行中，用选项 %1 表示同意。</translation>
    </message>
    <message>
        <source>A servo of this kind was left unfinished; it was to have ID %1. If this is that servo, press s and Enter; otherwise it is set up as a new one.</source>
        <translation>有一个同型号的舵机未完成，它应得到 ID %1。如果就是这一个，请按 s 再按回车；否则按新舵机设置。</translation>
    </message>
    <message>
        <source>A servo of this kind was left unfinished; no ID is left for another one. If this is that servo, press s and Enter; a and Enter: set it aside.</source>
        <translation>有一个同型号的舵机未完成，且已没有 ID 可给其他舵机。如果就是这一个，请按 s 再按回车；a 加回车：剔除。</translation>
    </message>
    <message>
        <source>A servo of this kind was left unfinished here. Go on only if this is that servo.</source>
        <translation>有一个同型号的舵机在此处未完成。仅当就是这一个时才继续。</translation>
    </message>
    <message>
        <source>No setting was changed; %1 has been removed again.</source>
        <translation>没有更改任何设置；已将 %1 删除。</translation>
    </message>
    <message>
        <source>Changes that were begun on other ports are open:</source>
        <translation>在其他端口上开始的更改尚未写完：</translation>
    </message>
    <message>
        <source>An adapter that is plugged in again may have another name. Where the servo is connected now, look at them with: %1</source>
        <translation>适配器重新插上后端口名可能改变。请在舵机现在所接的端口上查看：%1</translation>
    </message>
    <message>
        <source>No change was left open on %1.</source>
        <translation>%1 上没有未写完的更改。</translation>
    </message>
    <message>
        <source>At %1 baud the line never falls silent: something sends continuously. Servos may have been missed.</source>
        <translation>波特率 %1 下线路一直没有静默：有设备在不停发送。可能漏掉了舵机。</translation>
    </message>
    <message>
        <source>  File, and how many lines: %1</source>
        <translation>  文件及行数：%1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>The EPROM lock is open because a change of this servo was interrupted; to finish or undo it: %1</source>
        <translation>EPROM 锁未关闭，因为对该舵机的更改被中断；完成或撤销该更改：%1</translation>
    </message>
    <message>
        <source>something answers, but nothing readable</source>
        <translation>有应答，但无法识别</translation>
    </message>
    <message>
        <source>%1 registers</source>
        <translation>%1 个参数</translation>
    </message>
    <message>
        <source>Change %1:</source>
        <translation>更改 %1：</translation>
    </message>
    <message>
        <source>The trial was not run.</source>
        <translation>试用未运行。</translation>
    </message>
    <message>
        <source>Servo %1: most moves are too short for a verdict: targets count as reached within %2 steps, so moves need at least %3 steps.</source>
        <translation>舵机 %1：大多数行程太短，无法得出结论：距目标 %2 步以内即视为到位，因此每个行程至少需要 %3 步。</translation>
    </message>
    <message>
        <source>ignored: failed</source>
        <translation>已忽略：不合格</translation>
    </message>
    <message>
        <source>switch torque; on holds where the servo is, off is sent whatever speaks against writing</source>
        <translation>开关扭矩；on 保持当前位置，off 在任何情况下都会发送</translation>
    </message>
    <message>
        <source>end the motion; torque stays as it is, and goes off where holding cannot be proven</source>
        <translation>停止运动；扭矩状态不变，无法确认保持位置时卸力</translation>
    </message>
    <message>
        <source>An interrupted change is open on this port (ID %1). To look at it, finish it or undo it: %2</source>
        <translation>此端口上有被中断、尚未了结的更改（ID %1）。查看、完成或撤销：%2</translation>
    </message>
    <message>
        <source>Servo %1 may still have torque: switching it off after the test failed (%2). Use &quot;torque %1 off&quot;, or cut its supply.</source>
        <translation>舵机 %1 可能仍有扭矩：测试后卸力失败（%2）。请执行“torque %1 off”，或切断其供电。</translation>
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
        <source>some new, some old values</source>
        <translation>部分新值，部分原值</translation>
    </message>
    <message>
        <source>other values since, which stay</source>
        <translation>之后已是其他数值，保持不变</translation>
    </message>
    <message>
        <source>left as it is</source>
        <translation>保持不变</translation>
    </message>
    <message>
        <source>Change %1, left as they are, because they have another value since or would move the servo: %2</source>
        <translation>改动 %1：保持不变，因为之后已是其他数值，或写入会使舵机转动：%2</translation>
    </message>
    <message>
        <source>The change stays open; look at it with: servodesk-cli recover</source>
        <translation>此次更改仍未完成；请用以下命令查看：servodesk-cli recover</translation>
    </message>
    <message>
        <source>The values in the table stand in the servo. The snapshot that was taken before the first write has the earlier ones.</source>
        <translation>舵机中现在是表中的值。第一次写入前保存的快照里有原来的值。</translation>
    </message>
    <message>
        <source>Could not be put back: %1.</source>
        <translation>未能恢复原值：%1。</translation>
    </message>
    <message>
        <source>Servo %1 may still have torque and go on to its last goal: stopping it after the test failed (%2). Use &quot;torque %1 off&quot;, or cut its supply.</source>
        <translation>舵机 %1 可能仍有扭矩并继续走向最后的目标：测试结束后未能使其停止（%2）。请使用“torque %1 off”，或切断其供电。</translation>
    </message>
    <message>
        <source>Changes are open on this port:</source>
        <translation>此端口上有未完成的更改：</translation>
    </message>
    <message>
        <source>several changes begin with &quot;%1&quot;</source>
        <translation>有多个更改以“%1”开头</translation>
    </message>
    <message>
        <source>only this change (the first letters of its name will do)</source>
        <translation>仅处理此更改（名称的前几个字母即可）</translation>
    </message>
    <message>
        <source>also changes begun on a port that no longer exists, and with --change on one that does; the exit code is 1 while changes begun on other ports are open</source>
        <translation>同时处理在已不存在的端口上开始的更改，加 --change 时也包括仍然存在的端口；只要其他端口上开始的更改尚未完成，退出码就为 1</translation>
    </message>
    <message>
        <source>Without readings: %1. Legs with such a gap have no times and speeds.</source>
        <translation>无读数时段：%1。有这种中断的行程没有时间和速度。</translation>
    </message>
    <message>
        <source>still under way in another program</source>
        <translation>另一个程序仍在进行</translation>
    </message>
    <message>
        <source>Still under way in another program and left to it: %1</source>
        <translation>另一个程序仍在进行，由该程序完成：%1</translation>
    </message>
    <message>
        <source>Port %1 still exists. To see its changes (%2): %3</source>
        <translation>端口 %1 仍然存在。查看其更改（%2）：%3</translation>
    </message>
    <message>
        <source>Only if you know that the same servo is connected to %1 now: %2. Another servo of this model and ID cannot be told apart from it.</source>
        <translation>仅当您确定同一个舵机现在连接在 %1 上时：%2。无法将它与型号和 ID 相同的另一个舵机区分开。</translation>
    </message>
    <message>
        <source>Change %1 was begun on %2, which still exists. ServoDesk relies on your word that the servo on %3 is the same one.</source>
        <translation>更改 %1 是在 %2 上开始的，该端口仍然存在。%3 上的舵机是否为同一个，ServoDesk 以您的确认为准。</translation>
    </message>
    <message>
        <source>Torque off was sent (ID %1). Confirming …</source>
        <translation>已发送卸力（ID %1），正在确认…</translation>
    </message>
    <message>
        <source>No answer yet (ID %1): tried again after the others.</source>
        <translation>暂无应答（ID %1）：处理完其他舵机后再次尝试。</translation>
    </message>
    <message>
        <source>Confirming the stop (ID %1) …</source>
        <translation>正在确认停止（ID %1）…</translation>
    </message>
    <message>
        <source>Given up: change %1, servo %2 (%3, %4)</source>
        <translation>已放弃：更改 %1，舵机 %2（%3，%4）</translation>
    </message>
    <message>
        <source>Nothing was read: each register may hold its old or its new value.</source>
        <translation>未读取舵机：每个参数可能是原值，也可能是新值。</translation>
    </message>
    <message>
        <source>The EPROM lock may be open. &quot;info %1&quot; shows it; switching the servo off closes it.</source>
        <translation>EPROM 锁可能处于打开状态。“info %1”可以查看；给舵机断电即可锁上。</translation>
    </message>
    <message>
        <source>Unfinished: %1 that was to have ID %2. A part of its settings may be written. Connect it and run the same command again to finish it.</source>
        <translation>未完成：%1，应得到 ID %2。它的部分设置可能已写入。接上它并再次运行同一命令即可完成。</translation>
    </message>
    <message>
        <source>&quot;recover&quot; shows the changes that are open.</source>
        <translation>“recover”可显示尚未结束的更改。</translation>
    </message>
    <message>
        <source>Written temporarily, which is left out: the table has the stored value of %1</source>
        <translation>临时写入不计入，内存表中是保存的值：%1</translation>
    </message>
    <message>
        <source>Its ID was changed to %1 on %2: what was written to it with that ID is in the history of servo ID %1, not here</source>
        <translation>它的 ID 已于 %2 改为 %1：此后以该 ID 进行的写入在 ID %1 舵机的历史记录中，不在此处</translation>
    </message>
    <message>
        <source>Server and name of the bench were not stored</source>
        <translation>未保存服务器和工位名称</translation>
    </message>
    <message>
        <source>The name of the bench was stored; the server is set by SERVODESK_HISTORY_SERVER</source>
        <translation>已保存工位名称；服务器由 SERVODESK_HISTORY_SERVER 指定</translation>
    </message>
    <message>
        <source>Server and name of the bench were stored; the window uses them too</source>
        <translation>已保存服务器和工位名称，窗口程序也会使用</translation>
    </message>
    <message>
        <source>use server and name from now on, in the window too; stored once the server has been reached</source>
        <translation>从现在起使用此服务器和名称，窗口程序也一样；连接成功后才保存</translation>
    </message>
    <message>
        <source>The test could not be kept in the history: %1</source>
        <translation>测试无法存入历史：%1</translation>
    </message>
    <message>
        <source>It could not be left in a file beside the history either</source>
        <translation>也无法存为历史旁边的文件</translation>
    </message>
    <message>
        <source>Asking</source>
        <translation>正在询问</translation>
    </message>
    <message>
        <source>ID %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>Ended by you before it was confirmed (ID %1): torque off was sent, but nothing proves that it took effect.</source>
        <translation>尚未确认即被您中止（ID %1）：卸力指令已发送，但无法证明已生效。</translation>
    </message>
    <message>
        <source>Ended by you before it was confirmed (ID %1): these servos may still have torque and move.</source>
        <translation>尚未确认即被您中止（ID %1）：这些舵机可能仍有扭矩并在运动。</translation>
    </message>
    <message>
        <source>Ended by you before anything was sent (ID %1).</source>
        <translation>尚未发送任何命令即被您中止（ID %1）。</translation>
    </message>
    <message>
        <source>Ended by you before it was confirmed (ID %1): the torque of these servos may have been switched.</source>
        <translation>尚未确认即被您中止（ID %1）：这些舵机的扭矩可能已切换。</translation>
    </message>
</context>
<context>
    <name>text</name>
    <message>
        <source>it is given twice</source>
        <translation>重复给出</translation>
    </message>
    <message>
        <source>it has no acceleration setting</source>
        <translation>没有加速度参数</translation>
    </message>
    <message>
        <source>it has no speed setting</source>
        <translation>没有速度参数</translation>
    </message>
    <message>
        <source>its operating mode is not known</source>
        <translation>运行模式未知</translation>
    </message>
    <message>
        <source>it has no damping</source>
        <translation>没有阻尼功能</translation>
    </message>
    <message>
        <source>it has no torque switch</source>
        <translation>没有扭矩开关</translation>
    </message>
    <message>
        <source>it does not report its position</source>
        <translation>不反馈位置</translation>
    </message>
    <message>
        <source>no port is named</source>
        <translation>没有给出端口</translation>
    </message>
    <message>
        <source>Change the ID with set-id.</source>
        <translation>请用 set-id 修改 ID。</translation>
    </message>
    <message>
        <source>Change the baud rate with set-baud.</source>
        <translation>请用 set-baud 修改波特率。</translation>
    </message>
    <message>
        <source>Set the middle with center.</source>
        <translation>请用 center 设置中位。</translation>
    </message>
    <message>
        <source>Switch torque with torque; it then holds where the servo is.</source>
        <translation>请用 torque 切换扭矩开关；打开后保持在当前位置。</translation>
    </message>
    <message>
        <source>The lock is opened and closed around each write by itself; there is nothing to do.</source>
        <translation>每次写入都会自动解锁和上锁，无需手动操作。</translation>
    </message>
    <message>
        <source>this register is not simply written</source>
        <translation>此寄存器不能直接写入</translation>
    </message>
    <message>
        <source>this servo has no travel time in its present mode</source>
        <translation>此舵机在当前模式下没有运行时间</translation>
    </message>
    <message>
        <source>time and speed cannot be given together</source>
        <translation>时间和速度不能同时给出</translation>
    </message>
    <message>
        <source>in this mode the goal needs its unit (%1)</source>
        <translation>此模式下目标必须带单位（%1）</translation>
    </message>
    <message>
        <source>it did not come to rest in time</source>
        <translation>在规定时间内没有停下来</translation>
    </message>
    <message>
        <source>it came to rest %1 steps from its goal</source>
        <translation>停在离目标 %1 步处</translation>
    </message>
    <message>
        <source>the port is in use by %1</source>
        <translation>端口正被 %1 占用</translation>
    </message>
    <message>
        <source>the port may be opened by the group %1 only</source>
        <translation>只有用户组 %1 可以打开此端口</translation>
    </message>
    <message>
        <source>Changing it safely takes more than writing one register.</source>
        <translation>安全地修改它不只是写一个寄存器。</translation>
    </message>
    <message>
        <source>Give a speed instead of a time.</source>
        <translation>请改用速度参数。</translation>
    </message>
    <message>
        <source>there is no such port</source>
        <translation>没有这个端口</translation>
    </message>
    <message>
        <source>The adapter is not plugged in, its cable carries power only, or the name is misspelt.</source>
        <translation>适配器没有插好、USB 线只能供电，或端口名写错。</translation>
    </message>
    <message>
        <source>Plug the adapter in, use a data cable, and look at the list of ports.</source>
        <translation>插好适配器，换用数据线，再查看端口列表。</translation>
    </message>
    <message>
        <source>the port is in use</source>
        <translation>端口被占用</translation>
    </message>
    <message>
        <source>Another program has opened it; two programs on one bus would steal each other&apos;s answers.</source>
        <translation>其他程序已打开此端口；两个程序共用总线会互相抢走应答。</translation>
    </message>
    <message>
        <source>Close the other program, or use another port.</source>
        <translation>关闭其他程序，或换用别的端口。</translation>
    </message>
    <message>
        <source>the port may not be opened</source>
        <translation>没有权限打开端口</translation>
    </message>
    <message>
        <source>Your account does not belong to the group that owns serial ports.</source>
        <translation>您的账户不在拥有串口的用户组里。</translation>
    </message>
    <message>
        <source>Run &quot;sudo usermod -aG %1 $USER&quot;, then log in again.</source>
        <translation>执行 “sudo usermod -aG %1 $USER”，然后重新登录。</translation>
    </message>
    <message>
        <source>the port could not be opened</source>
        <translation>端口无法打开</translation>
    </message>
    <message>
        <source>The system refused it, or the other end did not accept the connection.</source>
        <translation>系统拒绝，或对方没有接受连接。</translation>
    </message>
    <message>
        <source>Unplug the adapter and plug it in again; for tcp:// check host and port.</source>
        <translation>重新插拔适配器；tcp:// 请核对主机和端口号。</translation>
    </message>
    <message>
        <source>this adapter cannot run at that baud rate</source>
        <translation>此适配器不支持该波特率</translation>
    </message>
    <message>
        <source>Its chip or driver knows only some of the rates.</source>
        <translation>其芯片或驱动只支持部分波特率。</translation>
    </message>
    <message>
        <source>Choose another baud rate, or use another adapter.</source>
        <translation>换用其他波特率或其他适配器。</translation>
    </message>
    <message>
        <source>the connection broke off</source>
        <translation>连接中断</translation>
    </message>
    <message>
        <source>The adapter was unplugged, its supply failed, or the far end closed the connection.</source>
        <translation>适配器被拔掉、断电，或对方关闭了连接。</translation>
    </message>
    <message>
        <source>Plug it in again. If a change was going on, look at the open changes (%recover) before anything else.</source>
        <translation>重新插好。如果正在修改参数，请先查看未完成的修改（%recover）。</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>No supply at the servo, a loose lead, another ID, another baud rate, or another protocol.</source>
        <translation>舵机未供电、接线松动，或 ID、波特率、协议不对。</translation>
    </message>
    <message>
        <source>Measure the voltage at the servo, check the lead, and search all baud rates.</source>
        <translation>测量舵机端电压，检查接线，并搜索所有波特率。</translation>
    </message>
    <message>
        <source>something answered, but nothing readable came</source>
        <translation>有应答，但无法识别</translation>
    </message>
    <message>
        <source>Two servos with one ID, a wrong baud rate, noise, long leads or no common ground.</source>
        <translation>ID 重复、波特率不对、干扰、线太长或未共地。</translation>
    </message>
    <message>
        <source>Connect this servo alone, check the ground lead, and search all baud rates.</source>
        <translation>只接这一个舵机，检查地线，并搜索所有波特率。</translation>
    </message>
    <message>
        <source>the answer does not belong to the question</source>
        <translation>应答与请求不符</translation>
    </message>
    <message>
        <source>A second program or master on the bus, or two servos with one ID.</source>
        <translation>总线上有另一个程序或主机，或 ID 重复。</translation>
    </message>
    <message>
        <source>Close other programs that use the bus, and connect this servo alone.</source>
        <translation>关闭使用总线的其他程序，只接这一个舵机。</translation>
    </message>
    <message>
        <source>the acknowledgement was lost, so it is not known whether the servo did it</source>
        <translation>没有收到应答，不能确定舵机是否已执行</translation>
    </message>
    <message>
        <source>A disturbed wire or a supply that dips. This request must not be repeated blindly.</source>
        <translation>线路受干扰或电压波动。此请求不能盲目重发。</translation>
    </message>
    <message>
        <source>Read the servo&apos;s state first, then decide whether to do it again.</source>
        <translation>先读取舵机状态，再决定是否重做。</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>You asked for it.</source>
        <translation>由您要求停止。</translation>
    </message>
    <message>
        <source>Start again when you are ready; what was not done yet has not been touched.</source>
        <translation>准备好后可重新开始；尚未执行的部分没有改动。</translation>
    </message>
    <message>
        <source>interrupted by the emergency stop</source>
        <translation>被急停打断</translation>
    </message>
    <message>
        <source>Torque was taken off the whole bus.</source>
        <translation>整条总线的扭矩已关闭。</translation>
    </message>
    <message>
        <source>Make sure that nothing can move, then start again.</source>
        <translation>确认不会有东西转动后再重新开始。</translation>
    </message>
    <message>
        <source>another task owns this servo now</source>
        <translation>此舵机正被另一项任务占用</translation>
    </message>
    <message>
        <source>A change is going on that must not be disturbed.</source>
        <translation>正在进行不能打断的修改。</translation>
    </message>
    <message>
        <source>Wait until it has ended, or stop it.</source>
        <translation>等它结束，或先停止它。</translation>
    </message>
    <message>
        <source>this cannot be understood</source>
        <translation>不能识别</translation>
    </message>
    <message>
        <source>A value is malformed, missing, or contradicts another one.</source>
        <translation>数值格式不对、缺失，或与其他参数矛盾。</translation>
    </message>
    <message>
        <source>Correct the value and try again.</source>
        <translation>改正后再试。</translation>
    </message>
    <message>
        <source>this servo has no register of that name</source>
        <translation>此舵机没有这个名称的寄存器</translation>
    </message>
    <message>
        <source>The name is misspelt, or belongs to another family.</source>
        <translation>名称写错，或属于其他系列。</translation>
    </message>
    <message>
        <source>Look the name up in the servo&apos;s memory table.</source>
        <translation>请在舵机内存表中查找名称。</translation>
    </message>
    <message>
        <source>this register can only be read</source>
        <translation>此寄存器只读</translation>
    </message>
    <message>
        <source>It is set by the factory or by the servo itself.</source>
        <translation>由出厂设定或舵机自己改写。</translation>
    </message>
    <message>
        <source>Choose a register that the memory table shows as read/write.</source>
        <translation>请选择内存表中标为“读写”的寄存器。</translation>
    </message>
    <message>
        <source>the value is outside what is allowed</source>
        <translation>数值超出允许范围</translation>
    </message>
    <message>
        <source>The register&apos;s range, or the servo&apos;s own angle limits, do not permit it.</source>
        <translation>超出寄存器范围或舵机自身的角度限制。</translation>
    </message>
    <message>
        <source>Give a value inside the range, or change the limits first.</source>
        <translation>给出范围内的数值，或先修改限制。</translation>
    </message>
    <message>
        <source>this register can make the servo unreachable or dangerous</source>
        <translation>写此寄存器可能使舵机失联或有危险</translation>
    </message>
    <message>
        <source>It decides how the servo is addressed, protected or turns.</source>
        <translation>它决定舵机的通信、保护或转向。</translation>
    </message>
    <message>
        <source>Save a snapshot, then repeat the write with your explicit consent.</source>
        <translation>先保存参数备份，再明确确认后重新写入。</translation>
    </message>
    <message>
        <source>this servo cannot do that</source>
        <translation>此舵机不支持该操作</translation>
    </message>
    <message>
        <source>Its family, firmware or present mode has no such thing.</source>
        <translation>其系列、固件或当前模式没有这项功能。</translation>
    </message>
    <message>
        <source>Look at the servo&apos;s model and mode, and use what it offers.</source>
        <translation>查看舵机型号和模式，使用它支持的功能。</translation>
    </message>
    <message>
        <source>another servo already has that ID</source>
        <translation>该 ID 已被另一个舵机使用</translation>
    </message>
    <message>
        <source>Two servos with one ID answer at the same time and garble each other.</source>
        <translation>两个舵机 ID 相同会同时应答，互相干扰。</translation>
    </message>
    <message>
        <source>Choose a free ID, or give the other servo a new one first.</source>
        <translation>换一个空闲的 ID，或先修改另一个舵机的 ID。</translation>
    </message>
    <message>
        <source>the servo did not do it</source>
        <translation>舵机没有执行</translation>
    </message>
    <message>
        <source>Its firmware does not accept this, a protection has tripped, or something is in the way.</source>
        <translation>固件不接受、已进入保护，或被卡住。</translation>
    </message>
    <message>
        <source>Look at the servo&apos;s status and mode, clear what blocks it, and try again.</source>
        <translation>查看舵机状态和模式，排除障碍后再试。</translation>
    </message>
    <message>
        <source>the servo shows another value than the one written</source>
        <translation>回读的数值与写入的不同</translation>
    </message>
    <message>
        <source>The firmware limits the value, or a second program wrote too.</source>
        <translation>固件限制了该数值，或有另一个程序也在写入。</translation>
    </message>
    <message>
        <source>Read the register again, and choose a value the servo accepts.</source>
        <translation>重新读取寄存器，换用舵机接受的数值。</translation>
    </message>
    <message>
        <source>the EPROM lock could not be proven closed</source>
        <translation>不能确认 EPROM 已上锁</translation>
    </message>
    <message>
        <source>The connection failed in the middle of a change.</source>
        <translation>修改过程中连接失败。</translation>
    </message>
    <message>
        <source>Restore the connection and finish or undo the change (%recover); switching the servo off closes the lock too.</source>
        <translation>恢复连接后完成或撤销修改（%recover）；舵机断电也会上锁。</translation>
    </message>
    <message>
        <source>no memory table fits this servo</source>
        <translation>没有适用于此舵机的内存表</translation>
    </message>
    <message>
        <source>Its firmware version belongs to no known family, so writing could do damage.</source>
        <translation>固件版本不属于任何已知系列，写入可能造成损坏。</translation>
    </message>
    <message>
        <source>Read its feedback only, or add a model file for it.</source>
        <translation>只读取反馈，或为它添加型号文件。</translation>
    </message>
    <message>
        <source>another servo answers under this ID</source>
        <translation>以此 ID 应答的是另一个舵机</translation>
    </message>
    <message>
        <source>The servo was exchanged since, or its ID was changed.</source>
        <translation>舵机已被更换，或 ID 已被修改。</translation>
    </message>
    <message>
        <source>Connect the servo that is meant, then try again.</source>
        <translation>接上原来的舵机后再试。</translation>
    </message>
    <message>
        <source>it is not known how many turns this servo has made</source>
        <translation>不知道此舵机转了多少圈</translation>
    </message>
    <message>
        <source>A multi-turn servo forgets its turns at power-off, and this one reports a single turn only.</source>
        <translation>多圈舵机断电后圈数丢失，而它只反馈单圈位置。</translation>
    </message>
    <message>
        <source>Move it to a known position with a goal of your own, or reference the axis first.</source>
        <translation>请自行给出目标使其转到已知位置，或先重新回零。</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>没有这个文件</translation>
    </message>
    <message>
        <source>The name is misspelt, or the file was moved.</source>
        <translation>文件名写错，或文件已被移走。</translation>
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
        <source>You may not read it, or the disk reports an error.</source>
        <translation>没有读取权限，或磁盘出错。</translation>
    </message>
    <message>
        <source>Check its permissions, or use a copy.</source>
        <translation>检查权限，或换用副本。</translation>
    </message>
    <message>
        <source>the file is not what it should be</source>
        <translation>文件内容不对</translation>
    </message>
    <message>
        <source>It is damaged, cut short, or of another kind.</source>
        <translation>文件损坏、不完整，或类型不对。</translation>
    </message>
    <message>
        <source>Use an undamaged copy, or make the file anew.</source>
        <translation>换用完好的副本，或重新生成。</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>文件无法写入</translation>
    </message>
    <message>
        <source>The folder is missing or read-only, or belongs to somebody else.</source>
        <translation>文件夹不存在、只读，或属于其他用户。</translation>
    </message>
    <message>
        <source>Choose a place you may write to.</source>
        <translation>请换到有写入权限的位置。</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>There is no room left, or your quota is used up.</source>
        <translation>没有剩余空间，或配额已用完。</translation>
    </message>
    <message>
        <source>Make room, then try again.</source>
        <translation>腾出空间后再试。</translation>
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
        <source>, tried %1 times</source>
        <translation>，已试 %1 次</translation>
    </message>
    <message>
        <source>%1.</source>
        <comment>full stop</comment>
        <translation>%1。</translation>
    </message>
    <message>
        <source>If an adapter with a CH340 chip (1a86:7523) appears and vanishes at once, the braille service has taken it: &quot;sudo apt remove brltty&quot;.</source>
        <translation>如果 CH340 适配器（1a86:7523）插上后立即消失，是被盲文服务占用了：“sudo apt remove brltty”。</translation>
    </message>
    <message>
        <source>servo %1</source>
        <translation>舵机 %1</translation>
    </message>
    <message>
        <source>Torque stays off until you switch it on.</source>
        <translation>扭矩保持关闭，直到您打开它。</translation>
    </message>
    <message>
        <source>It holds where it is (%3 = %1).</source>
        <translation>保持在当前位置（%3 = %1）。</translation>
    </message>
    <message>
        <source>The EPROM lock has been closed.</source>
        <translation>EPROM 已上锁。</translation>
    </message>
    <message>
        <source>%3 was set to 0, so that nothing moves in the new mode.</source>
        <translation>%3 已置 0，切换模式后不会转动。</translation>
    </message>
    <message>
        <source>The angle limits %1 … %2 are kept for the way back.</source>
        <translation>角度限制 %1 … %2 已记下，供切换回来时使用。</translation>
    </message>
    <message>
        <source>The angle limits %1 … %2 are back.</source>
        <translation>角度限制 %1 … %2 已恢复。</translation>
    </message>
    <message>
        <source>No earlier angle limits are known; %1 … %2 were set.</source>
        <translation>没有记下原来的角度限制；已设为 %1 … %2。</translation>
    </message>
    <message>
        <source>The position speed %1 (%3) is back.</source>
        <translation>位置模式的速度 %1（%3）已恢复。</translation>
    </message>
    <message>
        <source>%3 was set to 0, because the time acts only then.</source>
        <translation>%3 已置 0，否则运行时间不起作用。</translation>
    </message>
    <message>
        <source>The acknowledgement was lost; reading proved that it is done.</source>
        <translation>没有收到应答；回读确认已执行。</translation>
    </message>
    <message>
        <source>The acknowledgement was lost; reading proved that nothing had happened, so it was sent again.</source>
        <translation>没有收到应答；回读确认未执行，已重新发送。</translation>
    </message>
    <message>
        <source>The change was acknowledged under ID %1.</source>
        <translation>应答来自 ID %1。</translation>
    </message>
    <message>
        <source>It was so already; nothing was written.</source>
        <translation>原本就是如此；没有写入。</translation>
    </message>
    <message>
        <source>This takes effect at the next power-on.</source>
        <translation>下次上电后生效。</translation>
    </message>
    <message>
        <source>%3 is above %1, which is the highest useful value.</source>
        <translation>%3 超过 %1，这是有意义的最大值。</translation>
    </message>
    <message>
        <source>Stopped before %3 was written.</source>
        <translation>在写入 %3 之前停止。</translation>
    </message>
    <message>
        <source>Overload: only the holding torque is left. Take the load off and give a goal away from the stall.</source>
        <translation>过载：只剩保持扭矩。请去除负载，并给出远离堵转方向的目标。</translation>
    </message>
    <message>
        <source>Overcurrent: torque is off until a new goal is given. Remove the cause first.</source>
        <translation>过流：扭矩已关闭，重新写目标后恢复。请先排除原因。</translation>
    </message>
    <message>
        <source>Voltage: it passes when the supply is inside the servo&apos;s limits again.</source>
        <translation>电压：供电回到允许范围后自动解除。</translation>
    </message>
    <message>
        <source>Temperature: it passes by cooling only.</source>
        <translation>温度：只有冷却后才会解除。</translation>
    </message>
    <message>
        <source>Encoder: switch the servo off and on; if it returns, the servo needs repair.</source>
        <translation>编码器：请重新上电；如再次出现，需要返修。</translation>
    </message>
    <message>
        <source>It answered %1 ms after the restart.</source>
        <translation>重启后 %1 毫秒恢复应答。</translation>
    </message>
    <message>
        <source>It answers at %1 baud now.</source>
        <translation>现在以波特率 %1 应答。</translation>
    </message>
    <message>
        <source>It answers as ID %1 now.</source>
        <translation>现在以 ID %1 应答。</translation>
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
        <translation>舵机未接受</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不确定</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>已上锁</translation>
    </message>
    <message>
        <source>open</source>
        <translation>未上锁</translation>
    </message>
    <message>
        <source>not concerned</source>
        <translation>不涉及</translation>
    </message>
    <message>
        <source>TTL, one wire</source>
        <translation>TTL 单线</translation>
    </message>
    <message>
        <source>RS485</source>
        <translation>RS485</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
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
        <source>read only</source>
        <translation>只读</translation>
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
        <source>Torque was switched off.</source>
        <translation>扭矩已关闭。</translation>
    </message>
    <message>
        <source>The EPROM lock was found open.</source>
        <translation>发现 EPROM 没有上锁。</translation>
    </message>
    <message>
        <source>its memory table has no such register</source>
        <translation>其内存表没有这个寄存器</translation>
    </message>
    <message>
        <source>nobody could follow it through a TCP bridge</source>
        <translation>经 TCP 网桥无法跟随其新波特率</translation>
    </message>
    <message>
        <source>something answered there, but not readably</source>
        <translation>该处有应答，但无法识别</translation>
    </message>
    <message>
        <source>exception 1: it knows no such function</source>
        <translation>异常 1：不支持该功能码</translation>
    </message>
    <message>
        <source>exception 2: it has no such register</source>
        <translation>异常 2：没有该寄存器</translation>
    </message>
    <message>
        <source>exception 3: it does not take this value or length</source>
        <translation>异常 3：不接受该数值或长度</translation>
    </message>
    <message>
        <source>its protocol has no such instruction</source>
        <translation>该协议没有此指令</translation>
    </message>
    <message>
        <source>Modbus stations are 1 to 247</source>
        <translation>Modbus 站号为 1 到 247</translation>
    </message>
    <message>
        <source>IDs are 0 to 253, rates above 0</source>
        <translation>ID 为 0 到 253，波特率大于 0</translation>
    </message>
    <message>
        <source>it has no command for this</source>
        <translation>该系列没有此指令</translation>
    </message>
    <message>
        <source>Write the register %1 instead.</source>
        <translation>请改写寄存器 %1。</translation>
    </message>
    <message>
        <source>this ID answers in more than one protocol</source>
        <translation>此 ID 在多种协议下都有应答</translation>
    </message>
    <message>
        <source>Servos of different makes share the line and the ID.</source>
        <translation>不同厂家的舵机接在同一总线上，并且 ID 相同。</translation>
    </message>
    <message>
        <source>Say which is meant with --protocol, or give one of them another ID.</source>
        <translation>用 --protocol 指明协议，或给其中一个改 ID。</translation>
    </message>
    <message>
        <source>Reading proved that nothing had happened, so it was sent again.</source>
        <translation>回读确认没有生效，已重新发送。</translation>
    </message>
    <message>
        <source>Whether %3 survives power-off is not documented.</source>
        <translation>资料未说明 %3 断电后是否保存。</translation>
    </message>
    <message>
        <source>%3 was saved, as the data sheet has it; only switching the servo off and on could prove it.</source>
        <translation>%3 已按资料所述的指令保存；只有断电再上电才能验证。</translation>
    </message>
    <message>
        <source>%3 is 0, which allows no current: the servo has no torque.</source>
        <translation>%3 为 0，不允许任何电流：舵机没有扭矩。</translation>
    </message>
    <message>
        <source>The current limit %1 (%3) is back.</source>
        <translation>电流限制已恢复为 %1（%3）。</translation>
    </message>
    <message>
        <source>The temperature is above its limit (derived from its limits, not reported by the servo).</source>
        <translation>温度超过上限（由上限推算，并非舵机报告）。</translation>
    </message>
    <message>
        <source>The voltage is outside its limits (derived from its limits, not reported by the servo).</source>
        <translation>电压超出限值（由限值推算，并非舵机报告）。</translation>
    </message>
    <message>
        <source>SCS servos share this line with STS, SMS or HLS servos; the vendor advises against it.</source>
        <translation>SCS 舵机与 STS、SMS 或 HLS 舵机接在同一总线上；厂家不建议混用。</translation>
    </message>
    <message>
        <source>its baud rate cannot be changed</source>
        <translation>其波特率不能修改</translation>
    </message>
    <message>
        <source>This family runs at one rate and has no command for another.</source>
        <translation>该系列只有一种波特率，没有修改指令。</translation>
    </message>
    <message>
        <source>Set the other servos and the port to its rate.</source>
        <translation>把其他舵机和端口设为它的波特率。</translation>
    </message>
    <message>
        <source>it has no restart command</source>
        <translation>没有重启指令</translation>
    </message>
    <message>
        <source>This family knows none.</source>
        <translation>该系列没有这种指令。</translation>
    </message>
    <message>
        <source>Switch its supply off and on.</source>
        <translation>请断电后重新上电。</translation>
    </message>
    <message>
        <source>it cannot restore its defaults itself</source>
        <translation>不能自行恢复默认参数</translation>
    </message>
    <message>
        <source>This family has no command for it.</source>
        <translation>该系列没有这种指令。</translation>
    </message>
    <message>
        <source>Write the values back one by one.</source>
        <translation>请逐个写回数值。</translation>
    </message>
    <message>
        <source>it cannot share a packet with others</source>
        <translation>不能与其他舵机共用一个数据包</translation>
    </message>
    <message>
        <source>This family has no packet for several servos.</source>
        <translation>该系列没有同步写数据包。</translation>
    </message>
    <message>
        <source>Give the goals one by one.</source>
        <translation>请逐个给出目标。</translation>
    </message>
    <message>
        <source>it cannot hold a goal for later</source>
        <translation>不能暂存目标等待执行</translation>
    </message>
    <message>
        <source>This family has no write that waits for a start.</source>
        <translation>该系列没有异步写。</translation>
    </message>
    <message>
        <source>the mode and its command cannot be written together</source>
        <translation>模式与该模式的指令值不能同时写入</translation>
    </message>
    <message>
        <source>A change of mode begins with its command at zero, so that nothing turns by surprise.</source>
        <translation>切换模式时先把指令值清零，以免意外转动。</translation>
    </message>
    <message>
        <source>Change the mode first, then give the command.</source>
        <translation>请先切换模式，再给指令值。</translation>
    </message>
    <message>
        <source>Its speed follows from the travel time.</source>
        <translation>速度由运行时间决定。</translation>
    </message>
    <message>
        <source>Give a time instead.</source>
        <translation>请改给运行时间。</translation>
    </message>
    <message>
        <source>it does not answer to this read</source>
        <translation>对此读取无应答</translation>
    </message>
    <message>
        <source>Some models of this family lack the command; the line is in order.</source>
        <translation>该系列部分型号没有此指令；线路正常。</translation>
    </message>
    <message>
        <source>Do without this value.</source>
        <translation>此数值可以忽略。</translation>
    </message>
    <message>
        <source>the time goes together with a goal</source>
        <translation>时间须与目标一起写入</translation>
    </message>
    <message>
        <source>One command carries both, so writing the time alone would send the last goal once more.</source>
        <translation>两者在同一条指令中，单独写时间会重新发送上一次的目标。</translation>
    </message>
    <message>
        <source>Give goal and time together.</source>
        <translation>请同时给出目标和时间。</translation>
    </message>
    <message>
        <source>this setting is always kept</source>
        <translation>此参数总是断电保存</translation>
    </message>
    <message>
        <source>The servo stores it at once; it has no lock that could prevent that.</source>
        <translation>舵机立即保存，没有锁标志可以阻止。</translation>
    </message>
    <message>
        <source>Write it to stay, and write the old value back afterwards.</source>
        <translation>请正常写入，之后再写回旧值。</translation>
    </message>
    <message>
        <source>writing this turns the shaft at once</source>
        <translation>写入后输出轴会立即转动</translation>
    </message>
    <message>
        <source>The servo follows the new value as soon as it has it.</source>
        <translation>舵机收到新值后立即执行。</translation>
    </message>
    <message>
        <source>Keep clear of the mechanism, then repeat the write with your explicit consent.</source>
        <translation>请避开机构，再明确确认后重新写入。</translation>
    </message>
    <message>
        <source>not reported</source>
        <comment>alarms</comment>
        <translation>不报告</translation>
    </message>
    <message>
        <source>It is still on its way to the goal, until it is stopped or torque is off.</source>
        <translation>仍在运动到目标途中，停止或关闭扭矩才会停下。</translation>
    </message>
    <message>
        <source>it stands outside its limits (%1)</source>
        <translation>当前位置在限制之外（%1）</translation>
    </message>
    <message>
        <source>Holding it where it is would mean a goal beyond its limits.</source>
        <translation>保持在当前位置意味着目标超出限制。</translation>
    </message>
    <message>
        <source>Turn it by hand into its range, or move it to a goal inside.</source>
        <translation>请用手转回范围内，或给一个范围内的目标位置。</translation>
    </message>
    <message>
        <source>overload</source>
        <translation>过载</translation>
    </message>
    <message>
        <source>The load was above its threshold for too long: a stall, a jammed bracket, or more torque than the servo is rated for. Only the protection torque is left.</source>
        <translation>负载超过阈值时间过长：堵转、支架卡死，或所需扭矩超过额定值。只剩保护扭矩。</translation>
    </message>
    <message>
        <source>overcurrent</source>
        <translation>过流</translation>
    </message>
    <message>
        <source>The current was above its threshold for too long: a stall or a short circuit. The servo has switched its torque off.</source>
        <translation>电流超过阈值时间过长：堵转或短路。舵机已自动关闭扭矩。</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>过压欠压</translation>
    </message>
    <message>
        <source>The supply is outside the servo&apos;s limits: the wrong supply, one that is too small, or thin leads that drop under load.</source>
        <translation>供电超出舵机限值：电源不对、功率不足，或线太细、带载压降大。</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>过温</translation>
    </message>
    <message>
        <source>The servo is too hot: a long load, a stall, poor cooling, or a limit set low. Take the load off and let it cool.</source>
        <translation>舵机过温：长时间负载、堵转、散热差，或限值设得太低。请去除负载，等待冷却。</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>磁编码</translation>
    </message>
    <message>
        <source>The magnet, the encoder or a cable inside the servo is at fault. If the alarm returns after a power-cycle, the servo needs repair.</source>
        <translation>磁铁、编码器或内部连线故障。重新上电后仍报警，则需返修。</translation>
    </message>
    <message>
        <source>There is no alarm.</source>
        <translation>没有报警。</translation>
    </message>
    <message>
        <source>A small goal away from the stall releases it: the shaft turns back a little and is held there.</source>
        <translation>给一个稍微离开堵转方向的目标即可解除：输出轴往回转一点并保持。</translation>
    </message>
    <message>
        <source>A new goal releases it: its present place. Torque is switched on and holds there.</source>
        <translation>重新写目标即可解除：以当前位置为目标，打开扭矩并保持。</translation>
    </message>
    <message>
        <source>The fault reset register clears it. The servo is told to hold where it is first.</source>
        <translation>通过故障复位寄存器清除。先让舵机在当前位置保持。</translation>
    </message>
    <message>
        <source>It passes by itself when the value is back within its limits. Nothing is written.</source>
        <translation>数值回到限值之内会自动消失。不写入任何内容。</translation>
    </message>
    <message>
        <source>Only switching the servo off and on clears it.</source>
        <translation>只有断电后重新上电才能清除。</translation>
    </message>
    <message>
        <source>Nobody documents what this status bit means. Try switching the servo off and on.</source>
        <translation>没有资料说明这个状态位。请尝试断电后重新上电。</translation>
    </message>
    <message>
        <source>the braille service (brltty) has taken the adapter (%1)</source>
        <translation>盲文服务（brltty）占用了适配器（%1）</translation>
    </message>
    <message>
        <source>It takes adapters with this chip for braille displays, and their port vanishes.</source>
        <translation>它把这种芯片的适配器当作盲文显示器，串口因此消失。</translation>
    </message>
    <message>
        <source>If nobody here reads braille, run &quot;sudo apt remove brltty&quot;, then plug the adapter in again.</source>
        <translation>若本机无人使用盲文，请运行“sudo apt remove brltty”，然后重新插入适配器。</translation>
    </message>
    <message>
        <source>The LED setting (%3) could not be put back; it is noted in the journal. Use %recover when the servo answers again.</source>
        <translation>LED 设置（%3）未能恢复；已记入写入日志。舵机恢复应答后，请使用%recover处理。</translation>
    </message>
    <message>
        <source>it has no LED that can be switched</source>
        <translation>没有可控制的 LED</translation>
    </message>
    <message>
        <source>The map of this family has no register for it.</source>
        <translation>该系列的内存表没有对应的寄存器。</translation>
    </message>
    <message>
        <source>With torque off, turn a shaft by hand and see whose position changes.</source>
        <translation>请关闭扭矩，用手转动输出轴，看哪个舵机的位置在变化。</translation>
    </message>
    <message>
        <source>its LED belongs to the factory values</source>
        <translation>其 LED 属于出厂参数</translation>
    </message>
    <message>
        <source>Making it blink would mean unlocking and rewriting them many times.</source>
        <translation>要让它闪烁，就得解锁并多次改写出厂参数。</translation>
    </message>
    <message>
        <source>in this mode there is no small way back from the stall</source>
        <translation>此模式下无法只往回转一点来解除堵转</translation>
    </message>
    <message>
        <source>Only the opposite direction releases an overload, and here the shaft would turn on and on.</source>
        <translation>过载只能靠反方向解除，而在此模式下输出轴会一直转下去。</translation>
    </message>
    <message>
        <source>Take the load off and command the other direction yourself, or switch its supply off and on.</source>
        <translation>请去除负载，自行给出反方向指令，或断电后重新上电。</translation>
    </message>
    <message>
        <source>nothing tells which way it is stalled</source>
        <translation>无法判断堵转方向</translation>
    </message>
    <message>
        <source>It stands at its goal and drives neither way.</source>
        <translation>它停在目标处，没有向任何一侧出力。</translation>
    </message>
    <message>
        <source>Take the load off and give a goal away from the stall yourself, or switch its supply off and on.</source>
        <translation>请去除负载，自行给出离开堵转方向的目标，或断电后重新上电。</translation>
    </message>
    <message>
        <source>its angle limits leave no way back from the stall</source>
        <translation>角度限位不允许离开堵转位置</translation>
    </message>
    <message>
        <source>A goal away from the stall would lie outside them.</source>
        <translation>离开堵转位置的目标会超出限位。</translation>
    </message>
    <message>
        <source>Widen the limits, or switch its supply off and on.</source>
        <translation>请放宽限位，或断电后重新上电。</translation>
    </message>
    <message>
        <source>releasing this alarm moves the shaft</source>
        <translation>解除此报警会使输出轴转动</translation>
    </message>
    <message>
        <source>An overload is released by a goal away from the stall, and by nothing else.</source>
        <translation>过载只能靠反方向的目标解除。</translation>
    </message>
    <message>
        <source>Keep clear of the mechanism, then ask again with your explicit consent.</source>
        <translation>请避开机构，再明确确认后重新执行。</translation>
    </message>
    <message>
        <source>releasing this alarm switches torque on</source>
        <translation>解除此报警会打开扭矩</translation>
    </message>
    <message>
        <source>An overcurrent is released by a new goal, and by nothing else.</source>
        <translation>过流只能靠重新写目标解除。</translation>
    </message>
    <message>
        <source>Remove the cause and keep clear of the mechanism, then ask again with your explicit consent.</source>
        <translation>请排除原因并避开机构，再明确确认后重新执行。</translation>
    </message>
    <message>
        <source>the alarm is no longer the one you agreed to clear</source>
        <translation>报警已不是您同意清除的那一个</translation>
    </message>
    <message>
        <source>The servo&apos;s state has changed in between.</source>
        <translation>其间舵机状态已改变。</translation>
    </message>
    <message>
        <source>Look at the alarm again, then decide.</source>
        <translation>请重新查看报警，再作决定。</translation>
    </message>
    <message>
        <source>it is in another mode than the first</source>
        <translation>它的模式与第一个舵机不同</translation>
    </message>
    <message>
        <source>One goal for all would mean something else to it.</source>
        <translation>同一个目标对它有不同的含义。</translation>
    </message>
    <message>
        <source>Bring all of them into the same mode first.</source>
        <translation>请先把它们切换到同一模式。</translation>
    </message>
    <message>
        <source>the servos do not talk at one rate</source>
        <translation>这些舵机的波特率不一致</translation>
    </message>
    <message>
        <source>Nobody on the wire can be heard at two baud rates at the same time.</source>
        <translation>同一条总线上不能同时使用两种波特率通信。</translation>
    </message>
    <message>
        <source>Choose servos of one baud rate, or set them to the same one.</source>
        <translation>请选择波特率相同的舵机，或把它们改为同一波特率。</translation>
    </message>
    <message>
        <source>the emergency stop keeps it from moving</source>
        <translation>急停后禁止运动</translation>
    </message>
    <message>
        <source>Torque was taken off the whole bus and has not been switched on again since.</source>
        <translation>整条总线的扭矩输出已关闭，此后尚未重新打开。</translation>
    </message>
    <message>
        <source>Make sure that nothing can move, switch torque on first, then start again.</source>
        <translation>请确认不会有任何动作，先打开扭矩输出，再重新开始。</translation>
    </message>
    <message>
        <source>its operating mode is another one now</source>
        <translation>它的运行模式已经改变</translation>
    </message>
    <message>
        <source>Something else has switched it. In the new mode this goal would mean something else.</source>
        <translation>模式已被其他程序切换，这个目标在新模式下含义不同。</translation>
    </message>
    <message>
        <source>Look at the mode shown now, then give a goal for it.</source>
        <translation>请先查看现在的模式，再给出相应的目标。</translation>
    </message>
    <message>
        <source>this step would lead beyond ±7.5 turns</source>
        <translation>这一步将超出 ±7.5 圈</translation>
    </message>
    <message>
        <source>The servo counts no further; the steps made since it was connected are added up here.</source>
        <translation>舵机不能继续计数；此处累计的是连接以来的步进量。</translation>
    </message>
    <message>
        <source>Step back the other way.</source>
        <translation>请向相反方向步进。</translation>
    </message>
    <message>
        <source>nothing is being read</source>
        <translation>没有正在读取的数据</translation>
    </message>
    <message>
        <source>There is nothing that could be recorded.</source>
        <translation>没有可记录的内容。</translation>
    </message>
    <message>
        <source>Connect, select a servo and choose curves first.</source>
        <translation>请先连接、选择舵机并选择曲线。</translation>
    </message>
    <message>
        <source>a goal that waits in the servo could not be removed</source>
        <translation>舵机中等待的目标无法清除</translation>
    </message>
    <message>
        <source>The next Execute would start it, whoever sends it.</source>
        <translation>下一次“异步执行”会启动它，无论由谁发送。</translation>
    </message>
    <message>
        <source>Switch the servo off and on, then it has forgotten the goal.</source>
        <translation>请断电再上电，舵机就会忘记该目标。</translation>
    </message>
    <message>
        <source>it is not in a position mode</source>
        <translation>它不在位置模式</translation>
    </message>
    <message>
        <source>In its present mode goals are no places it could come to.</source>
        <translation>在当前模式下，目标不是可以到达的位置。</translation>
    </message>
    <message>
        <source>start and end are the same place</source>
        <translation>起点与终点相同</translation>
    </message>
    <message>
        <source>There would be no way to measure on.</source>
        <translation>没有可测量的行程。</translation>
    </message>
    <message>
        <source>Give two different places.</source>
        <translation>请给出两个不同的位置。</translation>
    </message>
    <message>
        <source>the step is 0</source>
        <translation>步长为 0</translation>
    </message>
    <message>
        <source>With it the end would never be reached.</source>
        <translation>这样永远到不了终点。</translation>
    </message>
    <message>
        <source>Give a step of 1 or more.</source>
        <translation>请给出不小于 1 的步长。</translation>
    </message>
    <message>
        <source>the step is longer than the whole way</source>
        <translation>步长大于整个行程</translation>
    </message>
    <message>
        <source>Start and end are nearer to each other than that.</source>
        <translation>起点与终点的距离比步长还小。</translation>
    </message>
    <message>
        <source>Give a smaller step, or a longer way.</source>
        <translation>请减小步长或加大行程。</translation>
    </message>
    <message>
        <source>the list has fewer than two targets</source>
        <translation>列表中的目标少于两个</translation>
    </message>
    <message>
        <source>A test goes from one place to another.</source>
        <translation>测试需要从一处运动到另一处。</translation>
    </message>
    <message>
        <source>Put at least two lines with a target into the file.</source>
        <translation>请在文件中至少写两行目标。</translation>
    </message>
    <message>
        <source>the delay is 0</source>
        <translation>延时为 0</translation>
    </message>
    <message>
        <source>The servo would be turned round before it has moved.</source>
        <translation>舵机还没动就会被要求返回。</translation>
    </message>
    <message>
        <source>Give the time a move needs and some more, or a dwell after arrival.</source>
        <translation>延时应大于运动所需时间，或改为到位后停留。</translation>
    </message>
    <message>
        <source>the test would never end</source>
        <translation>测试不会结束</translation>
    </message>
    <message>
        <source>Neither cycles nor a duration are given.</source>
        <translation>既没有给循环次数，也没有给时长。</translation>
    </message>
    <message>
        <source>Give a number of cycles or a duration.</source>
        <translation>请给出循环次数或时长。</translation>
    </message>
    <message>
        <source>the sine has no period</source>
        <translation>正弦没有周期</translation>
    </message>
    <message>
        <source>Nothing says how fast it is to be followed.</source>
        <translation>没有说明跟随的快慢。</translation>
    </message>
    <message>
        <source>Give the seconds of one period.</source>
        <translation>请给出一个周期的秒数。</translation>
    </message>
    <message>
        <source>it did not reach the start of the test</source>
        <translation>它没有到达测试起点</translation>
    </message>
    <message>
        <source>It is blocked, too weak or too slow, or its limits lie before that place.</source>
        <translation>可能被卡住、力量不足或太慢，或者限位在起点之前。</translation>
    </message>
    <message>
        <source>Free its way, then look at torque limit, speed and alarms.</source>
        <translation>请清除阻挡，再检查扭矩限制、速度和报警。</translation>
    </message>
    <message>
        <source>There would be nothing to answer to.</source>
        <translation>没有可响应的阶跃。</translation>
    </message>
    <message>
        <source>Give a step of 1 or more, or a negative one.</source>
        <translation>请给出不小于 1 的步数，或负数。</translation>
    </message>
    <message>
        <source>the time from goal to goal is out of reach</source>
        <translation>目标间隔时间超出范围</translation>
    </message>
    <message>
        <source>Every reading of a response is kept, for ten seconds at most.</source>
        <translation>每次响应的所有采样都会保存，最长十秒。</translation>
    </message>
    <message>
        <source>Give up to ten seconds, or none: then it is worked out.</source>
        <translation>请给出不超过十秒的时间，或留空由程序确定。</translation>
    </message>
    <message>
        <source>the number of repeats is out of reach</source>
        <translation>重复次数超出范围</translation>
    </message>
    <message>
        <source>Every reading is kept, of fifty steps there and back at most.</source>
        <translation>所有采样都会保存，最多往返五十次。</translation>
    </message>
    <message>
        <source>Give 1 to 50.</source>
        <translation>请给出 1 到 50。</translation>
    </message>
    <message>
        <source>this register is none that can be tried</source>
        <translation>该寄存器不能试用</translation>
    </message>
    <message>
        <source>A trial sets gains, startup force, integral limit and dead zones, as far as the servo has them.</source>
        <translation>试用只设置增益、启动力、积分限制和死区（视舵机而定）。</translation>
    </message>
    <message>
        <source>Write other registers in the memory table.</source>
        <translation>其他寄存器请在内存表中写入。</translation>
    </message>
    <message>
        <source>a test has the bus to itself</source>
        <translation>总线正被测试独占</translation>
    </message>
    <message>
        <source>Anything else on the wire would spoil what is being measured.</source>
        <translation>总线上的其他通信会影响测量结果。</translation>
    </message>
    <message>
        <source>Wait until the test has ended, or stop it.</source>
        <translation>请等测试结束，或停止测试。</translation>
    </message>
    <message>
        <source>it restarted before its first step</source>
        <translation>舵机在第一次阶跃之前已重启</translation>
    </message>
    <message>
        <source>Its power failed for a moment, and with that the values on trial were gone: it moved with its own.</source>
        <translation>供电曾短暂中断，试用的参数随之丢失：舵机是以自身参数运动的。</translation>
    </message>
    <message>
        <source>Look at plug and supply, then run the step again.</source>
        <translation>请检查插头和供电，然后重新运行阶跃测试。</translation>
    </message>
    <message>
        <source>an earlier register did not take its value</source>
        <translation>前面的寄存器未接受其值</translation>
    </message>
    <message>
        <source>the history was written by a newer version of this program</source>
        <translation>历史由本程序的较新版本写成</translation>
    </message>
    <message>
        <source>An older one cannot keep in it what it is about to change, so nothing is written to a servo.</source>
        <translation>较旧的版本无法把将要更改的内容记在其中，因此不向舵机写入任何内容。</translation>
    </message>
    <message>
        <source>Use the newer version, or another data folder (SERVODESK_DATA_DIR).</source>
        <translation>请使用较新的版本，或另一个数据文件夹（SERVODESK_DATA_DIR）。</translation>
    </message>
    <message>
        <source>the history is in use for too long</source>
        <translation>历史被占用过久</translation>
    </message>
    <message>
        <source>Another program keeps it locked, or it lies on a network drive that does not answer. Nothing is written to a servo without it.</source>
        <translation>另一个程序一直锁着它，或者它所在的网络盘没有应答。没有它就不向舵机写入。</translation>
    </message>
    <message>
        <source>Close other programs that have history.sqlite open, and try again.</source>
        <translation>关闭打开了 history.sqlite 的其他程序，然后重试。</translation>
    </message>
    <message>
        <source>the history database is damaged</source>
        <translation>历史数据库已损坏</translation>
    </message>
    <message>
        <source>The disk lost part of it, or the file is something else. Nothing is written to a servo without it.</source>
        <translation>磁盘丢失了其中一部分，或者文件是别的东西。没有它就不向舵机写入。</translation>
    </message>
    <message>
        <source>Close the program and move history.sqlite, with the files history.sqlite-wal and -shm, to a safe place; a new one is begun. &quot;sqlite3 history.sqlite .recover&quot; gets out of the old one what can be read.</source>
        <translation>关闭程序，把 history.sqlite 连同 history.sqlite-wal 和 -shm 移到安全的地方；程序会建立新的历史。&quot;sqlite3 history.sqlite .recover&quot; 可取出旧历史中还能读的内容。</translation>
    </message>
    <message>
        <source>the history cannot be written</source>
        <translation>历史无法写入</translation>
    </message>
    <message>
        <source>Its file or folder is read-only or belongs to somebody else. Nothing is written to a servo without it.</source>
        <translation>它的文件或文件夹是只读的，或属于别人。没有它就不向舵机写入。</translation>
    </message>
    <message>
        <source>Give yourself the right to write to both, or use another data folder (SERVODESK_DATA_DIR).</source>
        <translation>请取得两者的写权限，或使用另一个数据文件夹（SERVODESK_DATA_DIR）。</translation>
    </message>
    <message>
        <source>the journal of an earlier version cannot be read</source>
        <translation>较早版本的日志无法读取</translation>
    </message>
    <message>
        <source>It may hold a change that was interrupted, so nothing is written to a servo before it is in the history.</source>
        <translation>其中可能有被中断的更改，因此在它进入历史之前不向舵机写入。</translation>
    </message>
    <message>
        <source>Give yourself the right to read it, or move it away if you know that it is of no use.</source>
        <translation>请取得读取它的权限；如果确知它没有用处，请把它移走。</translation>
    </message>
    <message>
        <source>another servo has this label</source>
        <translation>另一个舵机已有此标签</translation>
    </message>
    <message>
        <source>It is alike in model, firmware and ID, and only the label tells the two apart.</source>
        <translation>两者型号、固件和 ID 相同，只有标签能区分。</translation>
    </message>
    <message>
        <source>Choose another label, or say that the servo that answers now is that one.</source>
        <translation>请换一个标签，或说明现在应答的舵机就是那一个。</translation>
    </message>
    <message>
        <source>no snapshot was taken by then</source>
        <translation>到那时还没有保存过快照</translation>
    </message>
    <message>
        <source>A table of the past is the last snapshot before it with the writes since then.</source>
        <translation>过去的内存表由此前最后一个快照加上此后的写入得出。</translation>
    </message>
    <message>
        <source>Choose a later time.</source>
        <translation>请选择较晚的时间。</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>相同</translation>
    </message>
    <message>
        <source>The servo has this value already; nothing is written.</source>
        <translation>舵机已是此值，不写入。</translation>
    </message>
    <message>
        <source>identity: off unless you ask</source>
        <translation>身份参数：需明确要求才写</translation>
    </message>
    <message>
        <source>ID and baud rate make this servo this servo. Written on request only, at the very end.</source>
        <translation>ID 和波特率决定这台舵机的身份。仅在要求时写入，且放在最后。</translation>
    </message>
    <message>
        <source>of the moment: never restored</source>
        <translation>瞬时值：从不恢复</translation>
    </message>
    <message>
        <source>Torque, goals and the lock are saved for the record. Writing them back could turn the shaft.</source>
        <translation>扭矩、目标和锁只作记录保存。写回可能使舵机轴转动。</translation>
    </message>
    <message>
        <source>lost at power-off: off unless you ask</source>
        <translation>掉电丢失：需明确要求才写</translation>
    </message>
    <message>
        <source>The servo sets it anew each time it is switched on.</source>
        <translation>舵机每次上电都会重新设定它。</translation>
    </message>
    <message>
        <source>shifts where the shaft&apos;s zero is</source>
        <translation>会移动轴的零点</translation>
    </message>
    <message>
        <source>After writing it the same goal is another place: the shaft may turn at once or when torque goes on.</source>
        <translation>写入后同一目标对应另一位置：轴可能立即转动，或在打开扭矩时转动。</translation>
    </message>
    <message>
        <source>can only be read</source>
        <translation>只读</translation>
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
        <source>It belongs to the values the factory has set for this very servo.</source>
        <translation>属于厂家为这台舵机设定的值。</translation>
    </message>
    <message>
        <source>dangerous: needs your consent</source>
        <translation>危险：需要您同意</translation>
    </message>
    <message>
        <source>this servo has no such register</source>
        <translation>此舵机没有该寄存器</translation>
    </message>
    <message>
        <source>The file is of another model or firmware; this row cannot be written here.</source>
        <translation>文件来自另一型号或固件；此行无法写入这台舵机。</translation>
    </message>
    <message>
        <source>not in the file</source>
        <translation>文件中没有</translation>
    </message>
    <message>
        <source>The file is of another model or firmware; this row stays as it is.</source>
        <translation>文件来自另一型号或固件；此行保持不变。</translation>
    </message>
    <message>
        <source>no value in the file</source>
        <translation>文件中没有值</translation>
    </message>
    <message>
        <source>It could not be read when the file was made.</source>
        <translation>保存文件时未能读出。</translation>
    </message>
    <message>
        <source>could not be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>What cannot be read cannot be proved, and is not written.</source>
        <translation>读不出的值无法验证，因此不写入。</translation>
    </message>
    <message>
        <source>outside this model&apos;s range</source>
        <translation>超出此型号的范围</translation>
    </message>
    <message>
        <source>This servo does not take the value in the file.</source>
        <translation>此舵机不接受文件中的值。</translation>
    </message>
    <message>
        <source>means something else here</source>
        <translation>在此舵机上含义不同</translation>
    </message>
    <message>
        <source>Unit or kind of number differ between the file&apos;s servo and this one.</source>
        <translation>文件中的舵机与这台舵机的单位或数值种类不同。</translation>
    </message>
    <message>
        <source>converted to this servo&apos;s steps</source>
        <translation>已换算为此舵机的步数</translation>
    </message>
    <message>
        <source>The same physical value; the raw number differs.</source>
        <translation>物理值相同，原始值不同。</translation>
    </message>
    <message>
        <source>a plain number of another family</source>
        <translation>另一系列的无单位数值</translation>
    </message>
    <message>
        <source>Without a unit nobody can say that it means the same here. Off unless you ask.</source>
        <translation>没有单位，无法确认在这里含义相同。需明确要求才写。</translation>
    </message>
    <message>
        <source>not chosen</source>
        <translation>未选择</translation>
    </message>
    <message>
        <source>Only some rows were asked for.</source>
        <translation>只要求了部分行。</translation>
    </message>
    <message>
        <source>torque off; it stays off</source>
        <translation>关闭扭矩，并保持关闭</translation>
    </message>
    <message>
        <source>open the lock</source>
        <translation>解锁</translation>
    </message>
    <message>
        <source>write and read back</source>
        <translation>写入并回读</translation>
    </message>
    <message>
        <source>bring to rest in the new mode</source>
        <translation>在新模式下归零静止</translation>
    </message>
    <message>
        <source>close the lock, prove it</source>
        <translation>上锁并验证</translation>
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
        <source>failed; everything is as before</source>
        <translation>失败；一切保持原样</translation>
    </message>
    <message>
        <source>would be written</source>
        <translation>将会写入</translation>
    </message>
    <message>
        <source>another servo; left alone</source>
        <translation>是另一台舵机；未作改动</translation>
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
        <source>; </source>
        <comment>between reasons</comment>
        <translation>； </translation>
    </message>
    <message>
        <source>the history server cannot be reached</source>
        <translation>无法连接历史服务器</translation>
    </message>
    <message>
        <source>It is switched off or restarting, the network is down, or its name or port is misspelt.</source>
        <translation>服务器已关机或正在重启、网络中断,或主机名或端口写错。</translation>
    </message>
    <message>
        <source>Nothing is lost: what it missed is sent when it is back. Check host and port of the connection string.</source>
        <translation>没有丢失任何数据:服务器恢复后会补发。请检查连接字符串中的主机和端口。</translation>
    </message>
    <message>
        <source>the history server does not answer</source>
        <translation>历史服务器没有应答</translation>
    </message>
    <message>
        <source>Something takes connections there and says nothing: a server that hangs, a firewall, or no PostgreSQL.</source>
        <translation>对方接受连接但不应答:服务器卡死、防火墙拦截,或对方不是 PostgreSQL。</translation>
    </message>
    <message>
        <source>Nothing is lost: what it missed is sent when it answers again. Check the server, host and port.</source>
        <translation>没有丢失任何数据:服务器恢复应答后会补发。请检查服务器、主机和端口。</translation>
    </message>
    <message>
        <source>the history server does not take this password</source>
        <translation>历史服务器不接受该密码</translation>
    </message>
    <message>
        <source>The password is wrong or missing, or there is no such user.</source>
        <translation>密码错误或缺失,或没有该用户。</translation>
    </message>
    <message>
        <source>the history server has no such database</source>
        <translation>历史服务器上没有该数据库</translation>
    </message>
    <message>
        <source>Its name is misspelt, or nobody has made it yet.</source>
        <translation>名称写错,或尚未创建。</translation>
    </message>
    <message>
        <source>Have it made on the server: &quot;createdb -E UTF8 -O USER DATABASE&quot;.</source>
        <translation>请在服务器上创建:&quot;createdb -E UTF8 -O USER DATABASE&quot;。</translation>
    </message>
    <message>
        <source>the history server does not permit this</source>
        <translation>历史服务器不允许此操作</translation>
    </message>
    <message>
        <source>This user may not log in from here, or may only read, or may not make tables in this database.</source>
        <translation>该用户不能从此处登录、只能读取,或不能在该数据库中建表。</translation>
    </message>
    <message>
        <source>Have the database&apos;s owner permit it (GRANT, pg_hba.conf), or use another user.</source>
        <translation>请数据库所有者授权(GRANT、pg_hba.conf),或换用其他用户。</translation>
    </message>
    <message>
        <source>the history server lets nobody in</source>
        <translation>历史服务器拒绝登录</translation>
    </message>
    <message>
        <source>It gives its reason in its own language.</source>
        <translation>服务器用自己的语言说明了原因。</translation>
    </message>
    <message>
        <source>Check user, password and database of the connection string, and the server&apos;s log.</source>
        <translation>请检查连接字符串中的用户、密码和数据库,以及服务器日志。</translation>
    </message>
    <message>
        <source>this computer cannot talk to PostgreSQL servers</source>
        <translation>本机无法与 PostgreSQL 服务器通信</translation>
    </message>
    <message>
        <source>Qt&apos;s driver for them is not installed.</source>
        <translation>未安装 Qt 的 PostgreSQL 驱动。</translation>
    </message>
    <message>
        <source>Install it, on Debian with &quot;sudo apt install libqt6sql6-psql&quot;, then start the program again.</source>
        <translation>请安装驱动(Debian:&quot;sudo apt install libqt6sql6-psql&quot;),然后重新启动程序。</translation>
    </message>
    <message>
        <source>the history server belongs to a newer version of this program</source>
        <translation>历史服务器属于本程序的更新版本</translation>
    </message>
    <message>
        <source>Another bench has been brought up to date, and has changed the tables there.</source>
        <translation>另一工位已升级,并更改了服务器上的表。</translation>
    </message>
    <message>
        <source>Bring this program up to date as well. Until then everything is kept on this computer.</source>
        <translation>请同样升级本程序。在此之前,所有数据都保存在本机。</translation>
    </message>
    <message>
        <source>the history server belongs to an older version of this program</source>
        <translation>历史服务器属于本程序的较旧版本</translation>
    </message>
    <message>
        <source>Its tables are brought up to date by the first bench of this version that sends something.</source>
        <translation>第一个用此版本发送数据的工位会升级服务器上的表。</translation>
    </message>
    <message>
        <source>Let a bench with this version send its history there.</source>
        <translation>请让一个使用此版本的工位向其发送历史。</translation>
    </message>
    <message>
        <source>nothing has ever been sent to this history server</source>
        <translation>尚未向该历史服务器发送过任何数据</translation>
    </message>
    <message>
        <source>No bench uses this database yet, or this is another one.</source>
        <translation>还没有工位使用该数据库,或连接到了别的数据库。</translation>
    </message>
    <message>
        <source>Set the connection string at the benches, then look again.</source>
        <translation>请在各工位设置连接字符串,然后再查看。</translation>
    </message>
    <message>
        <source>this database cannot keep every language</source>
        <translation>该数据库不能保存所有语言的文字</translation>
    </message>
    <message>
        <source>Its encoding is not UTF8.</source>
        <translation>其编码不是 UTF8。</translation>
    </message>
    <message>
        <source>Make another one: &quot;createdb -E UTF8 -T template0 DATABASE&quot;.</source>
        <translation>请另建一个:&quot;createdb -E UTF8 -T template0 DATABASE&quot;。</translation>
    </message>
    <message>
        <source>the history server is too busy</source>
        <translation>历史服务器太忙</translation>
    </message>
    <message>
        <source>It has as many connections as it allows, or somebody holds the tables.</source>
        <translation>连接数已达上限,或有人锁住了表。</translation>
    </message>
    <message>
        <source>Nothing is lost, and it is tried again by itself. If it stays so, look at the server.</source>
        <translation>没有丢失任何数据,程序会自动重试。若一直如此,请检查服务器。</translation>
    </message>
    <message>
        <source>the disk of the history server is full</source>
        <translation>历史服务器的磁盘已满</translation>
    </message>
    <message>
        <source>There is no room left for its tables.</source>
        <translation>没有空间存放其数据表。</translation>
    </message>
    <message>
        <source>Make room there. Until then everything is kept on this computer, and sent afterwards.</source>
        <translation>请在服务器上腾出空间。在此之前数据保存在本机,之后补发。</translation>
    </message>
    <message>
        <source>this is no connection string of PostgreSQL</source>
        <translation>这不是 PostgreSQL 的连接字符串</translation>
    </message>
    <message>
        <source>It is neither postgresql://USER@HOST/DATABASE nor host=HOST dbname=DATABASE user=USER, or has a part that is not known.</source>
        <translation>它既不是 postgresql://USER@HOST/DATABASE,也不是 host=HOST dbname=DATABASE user=USER,或含有无法识别的部分。</translation>
    </message>
    <message>
        <source>Correct it; PostgreSQL&apos;s manual describes it under &quot;Connection Strings&quot;.</source>
        <translation>请更正;PostgreSQL 手册的 &quot;Connection Strings&quot; 一节有说明。</translation>
    </message>
    <message>
        <source>the history server reports an error</source>
        <translation>历史服务器报告错误</translation>
    </message>
    <message>
        <source>Something there is not as this program expects it.</source>
        <translation>服务器上的某些内容与本程序的预期不符。</translation>
    </message>
    <message>
        <source>Nothing is lost, and it is tried again by itself. If it stays so, look at the server&apos;s log.</source>
        <translation>没有丢失任何数据,程序会自动重试。若一直如此,请查看服务器日志。</translation>
    </message>
    <message>
        <source>it did not restart</source>
        <translation>舵机没有重启</translation>
    </message>
    <message>
        <source>It answers, and its RAM is unchanged: it ignores the restart command, or never received it.</source>
        <translation>舵机有应答，RAM 内容未变：它不理会重启指令，或没有收到该指令。</translation>
    </message>
    <message>
        <source>it acknowledged the restart but did not restart</source>
        <translation>舵机应答了重启指令，但没有重启</translation>
    </message>
    <message>
        <source>It answers, and its RAM is unchanged.</source>
        <translation>舵机有应答，RAM 内容未变。</translation>
    </message>
    <message>
        <source>it could not be proven that it restarted</source>
        <translation>无法证实舵机已重启</translation>
    </message>
    <message>
        <source>It answers, but nothing shows a restart: it ignored the command, or started too quickly to be noticed.</source>
        <translation>舵机有应答，但没有迹象表明它重启过：它不理会该指令，或启动太快而未被察觉。</translation>
    </message>
    <message>
        <source>Switch its supply off and on to be sure.</source>
        <translation>请断电再上电，以确保重启。</translation>
    </message>
    <message>
        <source>Check the user in the connection string, and the password in ~/.pgpass (a line HOST:PORT:DATABASE:USER:PASSWORD, file mode 0600).</source>
        <translation>请检查连接字符串中的用户名，以及 ~/.pgpass 中的密码（一行 HOST:PORT:DATABASE:USER:PASSWORD，文件权限 0600）。</translation>
    </message>
    <message>
        <source>the history server and this computer cannot agree on encryption</source>
        <translation>历史记录服务器与本机无法就加密方式达成一致</translation>
    </message>
    <message>
        <source>One side requires TLS and the other does not offer it. Servers on other computers must use TLS (sslmode=verify-full) unless sslmode says otherwise.</source>
        <translation>一方要求 TLS，而另一方不提供。其他计算机上的服务器必须使用 TLS（sslmode=verify-full），除非用 sslmode 另行指定。</translation>
    </message>
    <message>
        <source>Enable TLS on the server (ssl = on). On a trusted network, sslmode=disable in the connection string sends everything unencrypted.</source>
        <translation>请在服务器上启用 TLS（ssl = on）。在可信网络中，可在连接字符串中写 sslmode=disable，此时所有数据不加密传输。</translation>
    </message>
    <message>
        <source>the certificate of the history server cannot be verified</source>
        <translation>无法验证历史记录服务器的证书</translation>
    </message>
    <message>
        <source>It is not issued by an authority this computer trusts, it has expired, or another computer is answering in the server&apos;s place.</source>
        <translation>证书不是由本机信任的机构签发的，或已过期，或者是另一台计算机在冒充该服务器应答。</translation>
    </message>
    <message>
        <source>Save the authority&apos;s certificate as ~/.postgresql/root.crt, or name its file with sslrootcert=FILE in the connection string. sslmode=require encrypts without verification.</source>
        <translation>请将签发机构的证书保存为 ~/.postgresql/root.crt，或在连接字符串中用 sslrootcert=FILE 指定其文件。sslmode=require 只加密而不验证。</translation>
    </message>
    <message>
        <source>the certificate of the history server is for another host name</source>
        <translation>历史记录服务器的证书属于另一个主机名</translation>
    </message>
    <message>
        <source>The connection string names the server differently, or another computer is answering in its place.</source>
        <translation>连接字符串中的服务器名称与证书不同，或者是另一台计算机在冒充它应答。</translation>
    </message>
    <message>
        <source>Use the host name in the certificate, or have a certificate issued for this one. sslmode=verify-ca checks only who issued it.</source>
        <translation>请使用证书中的主机名，或为此主机名签发证书。sslmode=verify-ca 只检查签发机构。</translation>
    </message>
    <message>
        <source>the connection string contains a password</source>
        <translation>连接字符串中含有密码</translation>
    </message>
    <message>
        <source>Others could read it in the settings and in the list of processes, so it is neither used nor saved.</source>
        <translation>其他人可能从设置文件和进程列表中读到它，因此既不使用也不保存。</translation>
    </message>
    <message>
        <source>Remove it from the string and store it in ~/.pgpass: a line HOST:PORT:DATABASE:USER:PASSWORD, file mode 0600.</source>
        <translation>请从连接字符串中删除密码，并将其存放在 ~/.pgpass 中：一行 HOST:PORT:DATABASE:USER:PASSWORD，文件权限 0600。</translation>
    </message>
    <message>
        <source>the password of the history server was removed from the settings</source>
        <translation>已从设置中删除历史记录服务器的密码</translation>
    </message>
    <message>
        <source>An earlier version saved it there as plain text.</source>
        <translation>早期版本曾将它以明文保存在设置中。</translation>
    </message>
    <message>
        <source>Store it in ~/.pgpass: a line HOST:PORT:DATABASE:USER:PASSWORD, file mode 0600. Change it if others could read the settings.</source>
        <translation>请将其存放在 ~/.pgpass 中：一行 HOST:PORT:DATABASE:USER:PASSWORD，文件权限 0600。如果他人可能读到过设置文件，请更换密码。</translation>
    </message>
    <message>
        <source>limit of another model</source>
        <translation>其他型号的限制</translation>
    </message>
    <message>
        <source>Limits of voltage, temperature, current and torque belong to a model. Off unless you select the row yourself.</source>
        <translation>电压、温度、电流和扭矩的限制与型号有关。除非您自己勾选该行，否则不写入。</translation>
    </message>
    <message>
        <source>would cause an alarm now</source>
        <translation>会立即引起报警</translation>
    </message>
    <message>
        <source>The present reading is outside this limit: the servo would be in an alarm as soon as it is written.</source>
        <translation>当前测量值超出此限制：一旦写入，舵机就会报警。</translation>
    </message>
    <message>
        <source>voltage alarm at once: limit %1, supply %2 now</source>
        <translation>立即过压欠压报警：限制 %1，当前电源 %2</translation>
    </message>
    <message>
        <source>temperature alarm at once: limit %1, servo %2 now</source>
        <translation>立即过热报警：限制 %1，舵机当前 %2</translation>
    </message>
    <message>
        <source>overcurrent alarm: limit %1, current %2 now</source>
        <translation>过流报警：限制 %1，当前电流 %2</translation>
    </message>
    <message>
        <source>overload alarm: limit %1, load %2 now</source>
        <translation>过载报警：限制 %1，当前负载 %2</translation>
    </message>
    <message>
        <source>this test did not finish, so it cannot be a reference</source>
        <translation>此测试未完成，不能作为参考</translation>
    </message>
    <message>
        <source>A test that was stopped or broken off has no verdict on a good servo.</source>
        <translation>停止或中断的测试对好的舵机没有结论。</translation>
    </message>
    <message>
        <source>Choose a test that ran to its end.</source>
        <translation>请选择已完成的测试。</translation>
    </message>
    <message>
        <source>the step is negative</source>
        <translation>步长为负</translation>
    </message>
    <message>
        <source>The path runs from the start to the end and back, so its step has no direction.</source>
        <translation>路径从起始到结束再返回，步长没有方向。</translation>
    </message>
    <message>
        <source>Give a step of 1 or more, and swap start and end for the other direction.</source>
        <translation>请给出 1 或更大的步长；若要反方向，请对调起始和结束。</translation>
    </message>
    <message>
        <source>its family is unclear</source>
        <translation>系列不明</translation>
    </message>
    <message>
        <source>Connect this servo alone and read it again. If the values stay the same, check the label on the servo, then add a model file that lists this model number with its real family.</source>
        <translation>请单独连接该舵机并重新读取。若数值不变，请核对舵机标签，再添加型号文件，写明该型号的实际系列。</translation>
    </message>
    <message>
        <source>two servos answer under this ID</source>
        <translation>有两个舵机用该 ID 应答</translation>
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
        <source>its family is unclear: firmware %1, byte order flag %2 and model number %3 contradict each other</source>
        <translation>系列不明：固件 %1、字节序标志 %2 与型号 %3 互相矛盾</translation>
    </message>
    <message>
        <source>its family is unclear: firmware %1, byte order flag %2 and model number %3 put the EPROM lock at address %4, but %5 stands there</source>
        <translation>系列不明：按固件 %1、字节序标志 %2 和型号 %3，EPROM 锁应在地址 %4，但该处的值为 %5</translation>
    </message>
    <message>
        <source>two servos answer under this ID: two replies came to one request</source>
        <translation>有两个舵机用该 ID 应答：一次请求收到两个应答</translation>
    </message>
    <message>
        <source>two servos answer under this ID: the same question gave replies that one servo cannot give</source>
        <translation>有两个舵机用该 ID 应答：同一请求的应答不可能出自一个舵机</translation>
    </message>
    <message>
        <source>two servos seem to answer under this ID: %1 of %2 replies were unreadable</source>
        <translation>可能有两个舵机用该 ID 应答：%2 个应答中有 %1 个无法辨认</translation>
    </message>
    <message>
        <source>Their replies collide and garble each other; a disturbed line can look the same. A write would change both, and only one of the old values would be recorded.</source>
        <translation>两者的应答互相冲突；线路受干扰时也会如此。写入会同时改动两个舵机，而只记录其中一个的原值。</translation>
    </message>
    <message>
        <source>Switch the servo off and on, and read it again. If the byte is still neither 0 nor 1, do not write to this servo: ask the vendor for its memory table.</source>
        <translation>请给舵机断电再上电，然后重新读取。若该字节仍不是 0 或 1，请勿写入该舵机，并向厂商索取其内存表。</translation>
    </message>
    <message>
        <source>A variant that the model list does not know, or a damaged identity. These facts choose the memory table; with the wrong table a write changes another register, so nothing is written.</source>
        <translation>型号表中没有的变型，或身份数据已损坏。内存表由这些信息决定；用错内存表，写入会改动别的参数，因此不写入任何内容。</translation>
    </message>
    <message>
        <source>Two servos with the same ID are connected. A write would change both, and only one of the old values would be recorded.</source>
        <translation>接有两个 ID 相同的舵机。写入会同时改动两个舵机，而只记录其中一个的原值。</translation>
    </message>
    <message>
        <source>the line never falls silent: something sends continuously</source>
        <translation>线路一直没有静默：有设备在不停发送</translation>
    </message>
    <message>
        <source>A device that sends on its own, a second master on the bus, an adapter or bridge set to another purpose, or noise on an open line.</source>
        <translation>有设备主动发送，总线上有另一个主机，适配器或网桥用于其他用途，或线路悬空引入噪声。</translation>
    </message>
    <message>
        <source>Disconnect everything but one servo, check the leads, and choose the right port.</source>
        <translation>只连接一个舵机，检查连线，并选择正确的端口。</translation>
    </message>
    <message>
        <source>lines of an earlier version&apos;s journal cannot be read</source>
        <translation>早期版本的写入日志中有无法读取的行</translation>
    </message>
    <message>
        <source>The file was damaged, or a newer program wrote to it. What can be read is in the history now; the file is kept.</source>
        <translation>文件已损坏，或由更新的程序写入。可读的内容已存入历史记录；文件予以保留。</translation>
    </message>
    <message>
        <source>Such a line may tell of an interrupted change: check the EPROM lock and the settings of servos that were in use then.</source>
        <translation>这样的行可能记录了中断的更改：请检查当时所用舵机的 EPROM 锁和设置。</translation>
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
        <source>Connect one servo at a time and change its ID. If only this servo is connected, check leads and ground, then try again: every attempt looks afresh. Switching torque off still reaches both.</source>
        <translation>每次只连接一个舵机并更改其 ID。如果只连接了这一个舵机，请检查导线和地线后重试：每次都会重新检查。卸力指令仍能到达两个舵机。</translation>
    </message>
    <message>
        <source>%1 Torque off was sent all the same; nothing proves that it took effect.</source>
        <translation>%1仍已发送卸力指令，但无法证明其已生效。</translation>
    </message>
    <message>
        <source>this servo failed the test, so it cannot be a reference</source>
        <translation>该舵机测试不合格，不能作为参考</translation>
    </message>
    <message>
        <source>A reference is what later tests of its model are compared with.</source>
        <translation>参考用于与该型号以后的测试对比。</translation>
    </message>
    <message>
        <source>Choose a servo that passed.</source>
        <translation>请选择一个合格的舵机。</translation>
    </message>
    <message>
        <source>Not recorded: the outcome of this change could not be saved to the history (%3). It stays listed as open; use %recover when the history can be written again.</source>
        <translation>未记录：这次更改的结果无法存入历史记录（%3）。它仍列为未了结；历史记录可以写入后，请使用%recover处理。</translation>
    </message>
    <message>
        <source>it restarted or was exchanged in the middle, so it is unknown whether the value is kept</source>
        <translation>舵机在写入过程中重新启动或被更换，因此不知道该值是否已保存</translation>
    </message>
    <message>
        <source>Its supply failed for a moment, or another servo was plugged in under this ID.</source>
        <translation>供电瞬间中断，或换上了 ID 相同的另一个舵机。</translation>
    </message>
    <message>
        <source>Check plug and supply, connect the servo that was written to, then look at the open change (%recover).</source>
        <translation>请检查插头和供电，接上原先写入的舵机，然后查看未写完的更改（%recover）。</translation>
    </message>
    <message>
        <source>it did not acknowledge, and every value is as before, so it is unknown whether it did it</source>
        <translation>舵机没有应答，所有值都与之前相同，因此不知道是否已执行</translation>
    </message>
    <message>
        <source>Its firmware ignores this command, or its settings were the defaults already.</source>
        <translation>固件忽略该指令，或其设置原本就是出厂值。</translation>
    </message>
    <message>
        <source>Compare its memory table with the defaults, and write what differs.</source>
        <translation>请将内存表与出厂值对比，并写入不同的值。</translation>
    </message>
    <message>
        <source>not kept yet</source>
        <translation>尚未永久保存</translation>
    </message>
    <message>
        <source>The servo has this value, but by a temporary write that ends at power-off. It is written once more, to be kept.</source>
        <translation>舵机现在是这个值，但来自断电即失效的临时写入。将再写一次，以永久保存。</translation>
    </message>
    <message>
        <source>no answer under this ID, but ID %1 replied</source>
        <translation>此 ID 无应答，但 ID %1 有应答</translation>
    </message>
    <message>
        <source>The servo answers under another ID than the one it hears, or a second program uses the bus.</source>
        <translation>舵机用另一个 ID 应答，或有另一个程序在使用总线。</translation>
    </message>
    <message>
        <source>Close other programs that use the bus, connect this servo alone, and search for it.</source>
        <translation>请关闭使用总线的其他程序，只连接这个舵机并进行搜索。</translation>
    </message>
    <message>
        <source>%3 could not be put back to %1; it is noted in the journal. Use %recover when the servo answers again. At power-off the servo forgets the temporary value by itself.</source>
        <translation>%3 未能恢复为 %1；已记入写入日志。舵机恢复应答后，请使用%recover处理。断电后舵机会自行丢弃临时值。</translation>
    </message>
    <message>
        <source>not written: the servo shows %1, where %2 was left; it would have become %3</source>
        <translation>未写入：舵机当前值为 %1，而之前写入的是 %2；本应改为 %3</translation>
    </message>
    <message>
        <source>another servo answers under this ID: %1</source>
        <translation>此 ID 下应答的是另一个舵机：%1</translation>
    </message>
    <message>
        <source>Another program has changed the value since, or the servo was exchanged for one of its kind.</source>
        <translation>此后有其他程序改动了该值，或舵机被换成了同型号的另一个。</translation>
    </message>
    <message>
        <source>Edit the value in the table if you want %1; this step is no longer offered.</source>
        <translation>如果需要 %1，请在参数表中修改；此步骤不再提供。</translation>
    </message>
    <message>
        <source>The EPROM lock could not be proven closed; it is noted in the journal. Use %recover when the servo answers again.</source>
        <translation>不能确认 EPROM 已上锁；已记入写入日志。舵机恢复应答后，请使用%recover处理。</translation>
    </message>
    <message>
        <source>this change is still under way in another program</source>
        <translation>另一个程序仍在进行此更改</translation>
    </message>
    <message>
        <source>The program that began it is still running.</source>
        <translation>开始此更改的程序仍在运行。</translation>
    </message>
    <message>
        <source>Wait until that program has finished. If it is stopped before, the change can be finished or undone here.</source>
        <translation>请等待该程序完成。如果它提前停止，可在此处完成或撤销此更改。</translation>
    </message>
    <message>
        <source>It may still be on its way to the goal, with torque on, until it is stopped or torque is off.</source>
        <translation>它可能仍在向目标位置运动，扭矩处于开启状态，直到被停止或卸力。</translation>
    </message>
    <message>
        <source>The goal switched torque on.</source>
        <translation>目标指令使能了扭矩。</translation>
    </message>
    <message>
        <source>Tick &quot;Switch to position mode&quot; for this test (--switch-mode on the command line), or change to position mode first.</source>
        <translation>为本次测试勾选“切换到位置模式”（命令行用 --switch-mode），或先改为位置模式。</translation>
    </message>
    <message>
        <source>the connection string contains a parameter that is not accepted</source>
        <translation>连接字符串中含有不接受的参数</translation>
    </message>
    <message>
        <source>It is misspelled, or it is none of the parameters that are known to hold no password.</source>
        <translation>参数名拼写有误，或不属于已知不含密码的参数。</translation>
    </message>
    <message>
        <source>Use host, hostaddr, port, dbname, user, service, connect_timeout, application_name, target_session_attrs and the parameters that begin with ssl, gss or keepalives.</source>
        <translation>可使用 host、hostaddr、port、dbname、user、service、connect_timeout、application_name、target_session_attrs，以及以 ssl、gss 或 keepalives 开头的参数。</translation>
    </message>
    <message>
        <source>Port → Interrupted writes</source>
        <translation>“端口 → 中断的写入”</translation>
    </message>
    <message>
        <source>not proven closed</source>
        <translation>未确认上锁</translation>
    </message>
    <message>
        <source>recover</source>
        <comment>command</comment>
        <translation>“recover”</translation>
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
        <source>Bench program for serial bus servos: Feetech SCS, STS, SMS, HLS, SMS over Modbus-RTU and Hiwonder LX.</source>
        <translation>串行总线舵机调试程序：飞特 SCS、STS、SMS、HLS，SMS 的 Modbus-RTU 协议，以及幻尔 LX。</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later, without any warranty. Icons: Breeze, by the KDE Visual Design Group, LGPL 3 or later. Built with Qt %1.</source>
        <translation>自由软件，遵循 GNU 通用公共许可证第 3 版或更高版本，不提供任何担保。图标：KDE Visual Design Group 的 Breeze，LGPL 3 或更高版本。使用 Qt %1 构建。</translation>
    </message>
    <message>
        <source>Journal and saved tables: %1</source>
        <translation>写入记录与参数备份：%1</translation>
    </message>
    <message>
        <source>Your own servo models (JSON files): %1</source>
        <translation>自定义舵机型号（JSON 文件）：%1</translation>
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
        <source>“%1”: each servo gets its own snapshot, by its ID. IDs and rates are never written here.</source>
        <translation>“%1”：按 ID 把各自的快照写回每个舵机。这里绝不写入 ID 和波特率。</translation>
    </message>
    <message>
        <source>“%1”: each ticked servo is read and gets the rows that differ. IDs and rates are never written here.</source>
        <translation>“%1”：逐个读取已勾选的舵机，只写入不同的行。这里绝不写入 ID 和波特率。</translation>
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
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>If a row fails, put this servo back as it was</source>
        <translation>若有一行失败，把该舵机恢复原样</translation>
    </message>
    <message>
        <source>Otherwise writing to this servo ends at the row that fails, and what is written stays</source>
        <translation>否则在失败的那一行停止写入该舵机，已写入的保留</translation>
    </message>
    <message>
        <source>Also where another model has the ID now</source>
        <translation>该 ID 现在是其他型号时也写入</translation>
    </message>
    <message>
        <source>By register name; what cannot be mapped is left out and listed</source>
        <translation>按寄存器名称对应；无法对应的会跳过并列出</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>预演</translation>
    </message>
    <message>
        <source>Read the servos and show what would be written to each</source>
        <translation>读取各舵机并显示将要写入的内容</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>Write the rows that differ to each ticked servo</source>
        <translation>向每个已勾选的舵机写入不同的行</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop after the servo that is being written to</source>
        <translation>写完当前舵机后停止</translation>
    </message>
    <message>
        <source>Save result…</source>
        <translation>保存结果…</translation>
    </message>
    <message>
        <source>Save what became of each row as a file</source>
        <translation>把每一行的结果保存为文件</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>关闭此窗口</translation>
    </message>
    <message>
        <source>Write to %1 servos?</source>
        <translation>写入 %1 个舵机？</translation>
    </message>
    <message>
        <source>Torque goes off at each servo that is written to, and stays off.</source>
        <translation>被写入的舵机会关闭扭矩，并保持关闭。</translation>
    </message>
    <message>
        <source>Dangerous rows are among those that are ticked: a wrong value can make a servo unreachable.</source>
        <translation>已勾选的行中有危险项：错误的值可能使舵机无法连接。</translation>
    </message>
    <message>
        <source>%1 of %2 servos did not come to it; the tooltip of each says why.</source>
        <translation>%2 个舵机中有 %1 个未成功；原因见各行提示。</translation>
    </message>
    <message>
        <source>Nothing was written. The tooltip of each servo lists its rows.</source>
        <translation>没有写入任何内容。各舵机的行见其提示。</translation>
    </message>
    <message>
        <source>All %1 servos are as the snapshot says.</source>
        <translation>全部 %1 个舵机已与快照一致。</translation>
    </message>
    <message>
        <source>Save the result</source>
        <translation>保存结果</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Data (*.json)</source>
        <translation>数据 (*.json)</translation>
    </message>
    <message>
        <source>Dangerous rows too</source>
        <translation>包括危险的行</translation>
    </message>
    <message>
        <source>Rows in which a wrong value can make a servo unreachable; left out otherwise</source>
        <translation>值错误时可能使舵机无法连接的行；不勾选则跳过</translation>
    </message>
    <message>
        <source>1 row left out</source>
        <translation>跳过 1 行</translation>
    </message>
    <message>
        <source>%1 rows left out</source>
        <translation>跳过 %1 行</translation>
    </message>
    <message>
        <source>Written, but rows were left out at %1 of %2 servos; the tooltip of each says which and why.</source>
        <translation>已写入，但 %2 个舵机中有 %1 个跳过了一些行；各行提示说明哪些及原因。</translation>
    </message>
    <message>
        <source>would cause an alarm now</source>
        <translation>会立即引起报警</translation>
    </message>
    <message>
        <source>old values not put back</source>
        <translation>未能恢复原值</translation>
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
        <source>bit %1, no name</source>
        <translation>位 %1（未命名）</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Bit %1, adds %2</source>
        <translation>位 %1，加 %2</translation>
    </message>
    <message>
        <source>Bit %1, adds %2; the sheet gives it no name, so it is kept as it is</source>
        <translation>位 %1，加 %2；资料中没有命名，因此保持原样</translation>
    </message>
    <message>
        <source>The sum of the ticked bits. %1</source>
        <translation>所勾选各位之和。%1</translation>
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
        <source>by its place</source>
        <translation>按顺序自动</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Find a register</source>
        <translation>查找寄存器</translation>
    </message>
    <message>
        <source>Part of its name</source>
        <translation>名称的一部分</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>What is ticked is read and shown</source>
        <translation>勾选的项目会被读取并显示</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>The colour of the chosen curve</source>
        <translation>所选曲线的颜色</translation>
    </message>
    <message>
        <source>Drawn times</source>
        <translation>绘制倍数</translation>
    </message>
    <message>
        <source>The curve is drawn as value × this + offset; cursors show the value itself</source>
        <translation>曲线按“数值 × 倍数 + 偏移”绘制；游标显示原值</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Added to the drawn value, in its unit</source>
        <translation>加到绘制值上，单位相同</translation>
    </message>
    <message>
        <source>As at first</source>
        <translation>恢复默认</translation>
    </message>
    <message>
        <source>Goal, position, speed and current of the selected servo</source>
        <translation>所选舵机的目标、位置、速度和电流</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close this list; the curves stay</source>
        <translation>关闭列表，曲线保留</translation>
    </message>
</context>
<context>
    <name>ui::ChecklistView</name>
    <message>
        <source>Search everything</source>
        <translation>全面搜索</translation>
    </message>
    <message>
        <source>All IDs at all rates in all protocols; writes nothing</source>
        <translation>全部 ID、全部波特率、全部协议；不写入任何内容</translation>
    </message>
    <message>
        <source>Show or hide what may be the cause</source>
        <translation>显示或隐藏可能的原因</translation>
    </message>
    <message>
        <source>ruled out</source>
        <translation>已排除</translation>
    </message>
    <message>
        <source>Ruled out: %1</source>
        <translation>已排除：%1</translation>
    </message>
    <message>
        <source>Tick off what you have looked at</source>
        <translation>检查过的打勾</translation>
    </message>
</context>
<context>
    <name>ui::CloseConfirmation</name>
    <message>
        <source>Servo %1 is turning. Stop it before closing?</source>
        <translation>舵机 %1 正在转动。关闭前停止它吗？</translation>
    </message>
    <message>
        <source>Servos %1 are turning. Stop them before closing?</source>
        <translation>舵机 %1 正在转动。关闭前停止它们吗？</translation>
    </message>
    <message>
        <source>Servo %1 is turning. Stop it before disconnecting?</source>
        <translation>舵机 %1 正在转动。断开前停止它吗？</translation>
    </message>
    <message>
        <source>Servos %1 are turning. Stop them before disconnecting?</source>
        <translation>舵机 %1 正在转动。断开前停止它们吗？</translation>
    </message>
    <message>
        <source>Stopping ends the motion; torque stays on where the servo can hold its position.</source>
        <translation>停止会结束运动；舵机能保持位置时扭矩保持开启。</translation>
    </message>
    <message>
        <source>Left turning, it does not stop by itself, and ServoDesk can no longer stop it.</source>
        <translation>若继续转动，它不会自行停止，ServoDesk 也无法再停止它。</translation>
    </message>
    <message>
        <source>Left moving, it goes on to its goal, and ServoDesk can no longer stop it.</source>
        <translation>若继续运动，它会走到目标位置，ServoDesk 无法再停止它。</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>停止并关闭</translation>
    </message>
    <message>
        <source>Stop and disconnect</source>
        <translation>停止并断开</translation>
    </message>
    <message>
        <source>Leave it turning</source>
        <translation>让它继续转动</translation>
    </message>
    <message>
        <source>Leave them turning</source>
        <translation>让它们继续转动</translation>
    </message>
    <message>
        <source>A test is running. Stop it and close?</source>
        <translation>测试正在运行。停止测试并关闭？</translation>
    </message>
    <message>
        <source>A test is running. Stop it and disconnect?</source>
        <translation>测试正在运行。停止测试并断开连接？</translation>
    </message>
    <message>
        <source>Its servos then hold their position with torque on.</source>
        <translation>之后舵机保持位置，扭矩开启。</translation>
    </message>
    <message>
        <source>Its servos then have no torque.</source>
        <translation>之后舵机卸力。</translation>
    </message>
    <message>
        <source>A write is unfinished. Close anyway?</source>
        <translation>有写入尚未写完。仍要关闭吗？</translation>
    </message>
    <message>
        <source>A write is unfinished. Disconnect anyway?</source>
        <translation>有写入尚未写完。仍要断开吗？</translation>
    </message>
    <message>
        <source>ID %1: the journal still holds the unfinished write. The next connection offers to finish or undo it.</source>
        <translation>ID %1：写入日志中仍有未写完的写入。下次连接时可选择完成或撤销。</translation>
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
        <source>The EPROM lock of ID %1 is open. It is closed first.</source>
        <translation>ID %1 的 EPROM 锁处于打开状态，将先上锁。</translation>
    </message>
    <message>
        <source>The EPROM lock of ID %1 is open and cannot be closed now.</source>
        <translation>ID %1 的 EPROM 锁处于打开状态，现在无法上锁。</translation>
    </message>
    <message>
        <source>The EPROM lock of the servo with ID %1 was opened and has not been proven closed.</source>
        <translation>ID 为 %1 的舵机的 EPROM 锁已打开，无法确认已重新上锁。</translation>
    </message>
    <message>
        <source>Lock and close</source>
        <translation>上锁并关闭</translation>
    </message>
    <message>
        <source>Lock and disconnect</source>
        <translation>上锁并断开</translation>
    </message>
    <message>
        <source>Leave it open</source>
        <translation>保持打开</translation>
    </message>
    <message>
        <source>The EPROM lock stays open: settings written by any program are kept at power-off.</source>
        <translation>EPROM 锁保持打开：任何程序写入的设置都会断电保存。</translation>
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
        <source>Was (ID, rate)</source>
        <translation>原 ID、波特率</translation>
    </message>
    <message>
        <source>Is (ID, rate)</source>
        <translation>现 ID、波特率</translation>
    </message>
    <message>
        <source>Rows written</source>
        <translation>写入项数</translation>
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
        <source>Table saved before the first write: %1</source>
        <translation>首次写入前的参数表已保存：%1</translation>
    </message>
</context>
<context>
    <name>ui::CommissionPage</name>
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
        <source>Lists (*.csv)</source>
        <translation>清单 (*.csv)</translation>
    </message>
    <message>
        <source>Connect first.</source>
        <translation>请先连接。</translation>
    </message>
    <message>
        <source>Say which file keeps the list of the batch.</source>
        <translation>请指定批次清单文件。</translation>
    </message>
    <message>
        <source>The last ID is below the first one.</source>
        <translation>末尾 ID 小于起始 ID。</translation>
    </message>
    <message>
        <source>The search goes on; the line can be started when it has ended.</source>
        <translation>正在搜索，结束后即可开始。</translation>
    </message>
    <message>
        <source>A test runs.</source>
        <translation>正在进行测试。</translation>
    </message>
    <message>
        <source>One servo after the other</source>
        <translation>逐个设置舵机</translation>
    </message>
    <message>
        <source>The line has ended</source>
        <translation>已结束</translation>
    </message>
    <message>
        <source>Connect the same servo again</source>
        <translation>请重新接上同一个舵机</translation>
    </message>
    <message>
        <source>Connect the next servo</source>
        <translation>请接上下一个舵机</translation>
    </message>
    <message>
        <source>Several servos answer: leave one</source>
        <translation>有多个舵机应答：请只留一个</translation>
    </message>
    <message>
        <source>Two servos under one ID: leave one</source>
        <translation>两个舵机 ID 相同：请只留一个</translation>
    </message>
    <message>
        <source>Somebody answers, but cannot be recognised</source>
        <translation>有应答，但无法识别</translation>
    </message>
    <message>
        <source>Set up as ID %1?</source>
        <translation>设为 ID %1？</translation>
    </message>
    <message>
        <source>Unplug it</source>
        <translation>请拔下</translation>
    </message>
    <message>
        <source>Unplug: ID %1 is done</source>
        <translation>请拔下：ID %1 已完成</translation>
    </message>
    <message>
        <source>Looking who is there …</source>
        <translation>正在检查总线 …</translation>
    </message>
    <message>
        <source>Setting up ID %1 …</source>
        <translation>正在设置 ID %1 …</translation>
    </message>
    <message>
        <source>Every servo is plugged in alone, gets template, ID and rate, is checked and noted in the batch. Nothing moves.</source>
        <translation>每次只接一个舵机，写入模板、ID 和波特率，检查后记入批次。舵机不会转动。</translation>
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
        <source>%1 at ID %2, %3 baud</source>
        <translation>%1：ID %2，波特率 %3</translation>
    </message>
    <message>
        <source>somebody</source>
        <translation>未识别</translation>
    </message>
    <message>
        <source>It gets ID %1.</source>
        <translation>将设为 ID %1。</translation>
    </message>
    <message>
        <source>It was begun before and is finished now.</source>
        <translation>先前未完成，现在继续。</translation>
    </message>
    <message>
        <source>Give it ID %1</source>
        <translation>设为 ID %1</translation>
    </message>
    <message>
        <source>Template, ID and rate are written; its table is saved first</source>
        <translation>写入模板、ID 和波特率；先保存其参数表</translation>
    </message>
    <message>
        <source>%1 done, %2 failed, %3 set aside, %4 unfinished</source>
        <translation>完成 %1，失败 %2，剔除 %3，未完成 %4</translation>
    </message>
    <message>
        <source>Commissioning</source>
        <translation>批量设置</translation>
    </message>
    <message>
        <source>The list of the batch (CSV); one that exists is gone on with</source>
        <translation>批次清单（CSV）；已有的文件将继续</translation>
    </message>
    <message>
        <source>Snapshot or template that every servo gets; empty: none</source>
        <translation>写入每个舵机的快照或模板；留空表示不写</translation>
    </message>
    <message>
        <source>First ID</source>
        <translation>起始 ID</translation>
    </message>
    <message>
        <source>The ID of the first servo; the next ones count on</source>
        <translation>第一个舵机的 ID，之后依次递增</translation>
    </message>
    <message>
        <source>Last ID</source>
        <translation>末尾 ID</translation>
    </message>
    <message>
        <source>The line ends when this ID has been given</source>
        <translation>分配完此 ID 后结束</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>The baud rate every servo gets</source>
        <translation>写入每个舵机的波特率</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Text of the labels: {model} {id} {rate} {baud} {firmware} {date} {was_id}</source>
        <translation>标签文字：{model} {id} {rate} {baud} {firmware} {date} {was_id}</translation>
    </message>
    <message>
        <source>Choose the file of the batch</source>
        <translation>选择批次文件</translation>
    </message>
    <message>
        <source>Choose the template</source>
        <translation>选择模板</translation>
    </message>
    <message>
        <source>as each has it</source>
        <translation>保持不变</translation>
    </message>
    <message>
        <source>Make the present position the middle</source>
        <translation>将当前位置校为中位</translation>
    </message>
    <message>
        <source>For servos with a centring command: put the horn where it belongs first</source>
        <translation>适用于有校中指令的舵机：请先将舵盘摆到位</translation>
    </message>
    <message>
        <source>Set up without asking</source>
        <translation>自动设置，不逐个确认</translation>
    </message>
    <message>
        <source>No click: what has an alarm or does not fit is set aside</source>
        <translation>无需点击：有报警或不符的舵机会被剔除</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Wait for the first servo, or go on with the batch</source>
        <translation>等待第一个舵机，或继续该批次</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>End the line; the batch can be gone on with at any time</source>
        <translation>结束；之后可随时继续该批次</translation>
    </message>
    <message>
        <source>Plug in the next servo</source>
        <translation>插入下一个舵机</translation>
    </message>
    <message>
        <source>Simulated servos: takes the next one of the bag</source>
        <translation>模拟舵机：取出下一个</translation>
    </message>
    <message>
        <source>Unplug</source>
        <translation>拔下</translation>
    </message>
    <message>
        <source>Simulated servos: takes it off the wire</source>
        <translation>模拟舵机：从总线上拔下</translation>
    </message>
    <message>
        <source>The same servo</source>
        <translation>是同一个舵机</translation>
    </message>
    <message>
        <source>It is the one that was begun; it gets the ID it was to have</source>
        <translation>这是先前未完成的舵机，使用原定 ID</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translation>剔除</translation>
    </message>
    <message>
        <source>Write nothing to this servo, and note it in the batch</source>
        <translation>不写入此舵机，并记入批次</translation>
    </message>
    <message>
        <source>Copy labels</source>
        <translation>复制标签</translation>
    </message>
    <message>
        <source>Labels of the selected servos, or of all, one a line</source>
        <translation>复制所选（或全部）舵机的标签，每行一个</translation>
    </message>
    <message>
        <source>Servos of the batch</source>
        <translation>批次中的舵机</translation>
    </message>
    <message>
        <source>One line a servo, as in the file of the batch</source>
        <translation>每个舵机一行，与批次文件一致</translation>
    </message>
    <message>
        <source>A wrong value can make a servo unreachable or dangerous: %1</source>
        <translation>数值错误可能导致舵机失联或发生危险：%1</translation>
    </message>
    <message>
        <source>Write dangerous rows to every servo?</source>
        <translation>向每个舵机写入危险项？</translation>
    </message>
    <message>
        <source>The template has: %1</source>
        <translation>模板中包含：%1</translation>
    </message>
    <message>
        <source>A wrong value can make a servo unreachable or dangerous, and every servo of the batch gets it.</source>
        <translation>数值错误可能导致舵机失联或发生危险，且本批次的每个舵机都会写入。</translation>
    </message>
    <message>
        <source>Write anyway</source>
        <translation>仍然写入</translation>
    </message>
    <message>
        <source>The name of a file has a character in it that no file can have.</source>
        <translation>文件名中含有不允许的字符。</translation>
    </message>
    <message>
        <source>The batch cannot be gone on with.</source>
        <translation>此批次无法继续。</translation>
    </message>
    <message>
        <source>The template cannot be read.</source>
        <translation>模板无法读取。</translation>
    </message>
    <message>
        <source>Looking who is on the wire now, since the servos of the list have changed.</source>
        <translation>列表中的舵机已变化，正在搜索当前总线上的舵机。</translation>
    </message>
    <message>
        <source>Connect the servos to each other and search to see them all.</source>
        <translation>将舵机串联后搜索，即可看到全部舵机。</translation>
    </message>
    <message>
        <source>Table saved before the first write: %1 in %2</source>
        <translation>首次写入前的参数表已保存：%1，位于 %2</translation>
    </message>
    <message>
        <source>Dangerous rows of the template too</source>
        <translation>同时写入模板中的危险项</translation>
    </message>
    <message>
        <source>%1 for ID %2</source>
        <translation>%1（ID %2）</translation>
    </message>
    <message>
        <source>Unfinished: %1. Connect the servo and start the same batch again to finish it.</source>
        <translation>未完成：%1。接上该舵机，再次开始同一批次即可完成。</translation>
    </message>
    <message>
        <source>A servo of this kind was left unfinished; it was to have ID %1. If this is that servo, click &quot;%2&quot;; otherwise it is set up as a new one.</source>
        <translation>有一个同型号的舵机未完成，它应得到 ID %1。如果就是这一个，请点“%2”；否则按新舵机设置。</translation>
    </message>
    <message>
        <source>A servo of this kind was left unfinished; no ID is left for another one. If this is that servo, click &quot;%1&quot;.</source>
        <translation>有一个同型号的舵机未完成，且已没有 ID 可给其他舵机。如果就是这一个，请点“%1”。</translation>
    </message>
    <message>
        <source>A servo of this kind was left unfinished here. Continue only if this is that servo.</source>
        <translation>有一个同型号的舵机在此处未完成。仅当就是这一个时才继续。</translation>
    </message>
    <message>
        <source>%1, ID %2</source>
        <translation>%1，ID %2</translation>
    </message>
</context>
<context>
    <name>ui::CompareDialog</name>
    <message>
        <source>Save as page…</source>
        <translation>保存为网页…</translation>
    </message>
    <message>
        <source>Save the comparison as a page in both languages</source>
        <translation>将对比保存为双语网页</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close this comparison</source>
        <translation>关闭此对比</translation>
    </message>
    <message>
        <source>What was different between the two tests</source>
        <translation>两次测试之间的差异</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Figures of both servos; the difference is B less A</source>
        <translation>两个舵机的指标；差值为 B 减 A</translation>
    </message>
    <message>
        <source>Settings of the servos that were different at the start of the tests</source>
        <translation>测试开始时两个舵机不同的参数</translation>
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
        <source>Figure</source>
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
        <source>Page (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
</context>
<context>
    <name>ui::CompareModel</name>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>no such register</source>
        <translation>没有此寄存器</translation>
    </message>
    <message>
        <source>left alone</source>
        <translation>不改动</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>寄存器</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
</context>
<context>
    <name>ui::ConnectBar</name>
    <message>
        <source>not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>opening the port …</source>
        <translation>正在打开串口…</translation>
    </message>
    <message>
        <source>closing the port …</source>
        <translation>正在关闭串口…</translation>
    </message>
    <message>
        <source>unplugged</source>
        <translation>已拔出</translation>
    </message>
    <message>
        <source>%1 reads/s · %2 error · wire %3 %</source>
        <translation>%1 次/秒 · %2 错误 · 总线 %3 %</translation>
    </message>
    <message>
        <source>%1 reads/s · %2 errors · wire %3 %</source>
        <translation>%1 次/秒 · %2 错误 · 总线 %3 %</translation>
    </message>
    <message>
        <source>%1/s · %2 err</source>
        <translation>%1 次/秒 · %2 错误</translation>
    </message>
    <message>
        <source>Port: %1 at %2 baud
Sent: %3, answered: %4
Lost: %5, damaged: %6, foreign: %7, late: %8
Asked more than once: %9</source>
        <translation>端口：%1，波特率 %2
已发送：%3，已应答：%4
丢失：%5，损坏：%6，异常来源：%7，迟到：%8
重发：%9</translation>
    </message>
    <message>
        <source>Round trip: %1 ms, the slowest of 100: %2 ms</source>
        <translation>往返时间：%1 毫秒，百次中最慢：%2 毫秒</translation>
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
        <source>Rate at which the port is opened. Auto: what servos of the chosen protocol leave the factory with</source>
        <translation>打开串口所用的波特率。自动：所选协议舵机的出厂波特率</translation>
    </message>
    <message>
        <source>Protocol: auto</source>
        <translation>协议：自动</translation>
    </message>
    <message>
        <source>Feetech</source>
        <translation>飞特</translation>
    </message>
    <message>
        <source>Modbus</source>
        <translation>Modbus</translation>
    </message>
    <message>
        <source>LX</source>
        <translation>LX</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>协议</translation>
    </message>
    <message>
        <source>Language of the servos. Auto: all that can be met at the rate are tried</source>
        <translation>舵机的通信协议。自动：尝试该波特率下可能出现的全部协议</translation>
    </message>
    <message>
        <source> (something is set)</source>
        <translation>（已有设置）</translation>
    </message>
    <message>
        <source>More about the port</source>
        <translation>更多串口设置</translation>
    </message>
    <message>
        <source>Parity, time-out, Modbus silence, retries</source>
        <translation>校验位、超时、Modbus 帧间隔、重试次数</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>These servos exist in the computer only</source>
        <translation>这些舵机只存在于电脑中</translation>
    </message>
    <message>
        <source>adapter gone, waiting up to 5 s</source>
        <translation>适配器已断开，等待恢复（最多 5 秒）</translation>
    </message>
    <message>
        <source>waiting …</source>
        <translation>等待恢复…</translation>
    </message>
    <message>
        <source>The adapter has been pulled out or has no power. A test that is running goes on when it is back; a servo that has restarted meanwhile is not switched on.</source>
        <translation>适配器已拔出或断电。恢复后正在运行的测试将继续；其间已重启的舵机不会再次输出扭矩。</translation>
    </message>
</context>
<context>
    <name>ui::ControlField</name>
    <message>
        <source>not accepted</source>
        <translation>不接受</translation>
    </message>
</context>
<context>
    <name>ui::ControlFields</name>
    <message>
        <source>Current 0 = no torque at all</source>
        <translation>电流 0 = 完全没有扭矩</translation>
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
        <source>Time (ms)</source>
        <translation>时间 (ms)</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>电流限制</translation>
    </message>
</context>
<context>
    <name>ui::ControlGoal</name>
    <message>
        <source>Since connecting: %1 steps. Left: %2 %3, %4 %5 (±7.5 turns in all)</source>
        <translation>连接以来：%1 步。剩余：%2 %3，%4 %5（总共 ±7.5 圈）</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Step</source>
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
        <source>Drag, or arrows, Page Up/Down, Home and End. The wheel turns it once it has been clicked (Ctrl: fine, Shift: wide).</source>
        <translation>拖动，或用方向键、Page Up/Down、Home 和 End。点击之后滚轮才起作用（Ctrl：微调，Shift：大步）。</translation>
    </message>
    <message>
        <source>One step this way from where the last one ends</source>
        <translation>从上一步的终点朝这个方向再走一步</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>再来一次</translation>
    </message>
    <message>
        <source>The last step once more</source>
        <translation>重复上一步</translation>
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
        <source>Ends the motion of this servo; torque stays on</source>
        <translation>结束此舵机的运动；扭矩保持打开</translation>
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
        <source>Largest output; sent when the knob is let go</source>
        <translation>最大输出；松开滑块时发送</translation>
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
        <source>From the data sheet at your supply voltage; remembered for this model, written nowhere</source>
        <translation>取自对应供电电压的规格书；按型号记住，不写入舵机</translation>
    </message>
    <message>
        <source>Gripping: set the share of the stall torque the part can take (10 % of 10 kg·cm is about 1 kg·cm). The servo also gets slower. Only for parts of equal mass.</source>
        <translation>夹持：按物体能承受的程度设置堵转扭矩的百分比（10 kg·cm 的 10 % 约 1 kg·cm）。速度会变慢；仅适合质量相同的物品。</translation>
    </message>
    <message>
        <source>Share of the stall torque. Enter sends it; Esc takes torque off the whole bus and shows the present value again.</source>
        <translation>堵转扭矩的百分比。按回车发送；按 Esc 让整条总线卸力，并重新显示当前值。</translation>
    </message>
</context>
<context>
    <name>ui::ControlMode</name>
    <message>
        <source>%1. A click says first what the switch will change.</source>
        <translation>%1。点击后先说明切换会改变什么。</translation>
    </message>
    <message>
        <source>Operating mode</source>
        <translation>工作模式</translation>
    </message>
</context>
<context>
    <name>ui::ControlPanel</name>
    <message>
        <source>Choose a servo at the left. Choosing it moves nothing.</source>
        <translation>请在左侧选择舵机。选择不会使其运动。</translation>
    </message>
    <message>
        <source>This servo answers, but does not say what it is, so nobody knows how to move it. Search again, or check whether two servos share the ID.</source>
        <translation>此舵机有应答，但未说明自己是什么，因此不知道如何驱动。请重新搜索，或检查是否有两个舵机共用此 ID。</translation>
    </message>
    <message>
        <source>The firmware of this servo is not known. Its measurements are shown; moving it could do damage. A model file makes it possible.</source>
        <translation>此舵机的固件未知。只显示其测量值；驱动它可能造成损坏。提供型号文件后即可操作。</translation>
    </message>
    <message>
        <source>The settings of this servo could not be read.</source>
        <translation>无法读取此舵机的设置。</translation>
    </message>
    <message>
        <source>Reading the settings of this servo…</source>
        <translation>正在读取此舵机的设置…</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>舵机操作</translation>
    </message>
    <message>
        <source>Motion — ID %1</source>
        <translation>舵机操作 — ID %1</translation>
    </message>
    <message>
        <source>+ %1 more</source>
        <translation>及另外 %1 个</translation>
    </message>
    <message>
        <source>Execute (%1)</source>
        <translation>异步执行 (%1)</translation>
    </message>
    <message>
        <source>Execute</source>
        <translation>异步执行</translation>
    </message>
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
    <message>
        <source>Stopped. Switch torque on to go on.</source>
        <translation>已停止。打开扭矩后继续。</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>普通写</translation>
    </message>
    <message>
        <source>One servo after the other, each acknowledged</source>
        <translation>逐个舵机写入，每个都有应答</translation>
    </message>
    <message>
        <source>One packet for all chosen servos: they start together</source>
        <translation>所有选中的舵机共用一个数据包：同时启动</translation>
    </message>
    <message>
        <source>The goal waits in the servo until Execute</source>
        <translation>目标保存在舵机中，等待异步执行</translation>
    </message>
    <message>
        <source>Starts all goals that wait in servos</source>
        <translation>启动所有在舵机中等待的目标</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Sends goal and changed fields</source>
        <translation>发送目标和已修改的参数</translation>
    </message>
    <message>
        <source>Sync</source>
        <translation>同步写</translation>
    </message>
    <message>
        <source>Async</source>
        <translation>异步写</translation>
    </message>
    <message>
        <source>Stopped, but torque is on. Press Esc to switch it off.</source>
        <translation>已急停，但扭矩仍为开启。按 Esc 卸力。</translation>
    </message>
</context>
<context>
    <name>ui::ControlTorque</name>
    <message>
        <source>Damping</source>
        <translation>阻尼</translation>
    </message>
    <message>
        <source>Holds nothing, but brakes the shaft when it is turned</source>
        <translation>不保持位置，但转动输出轴时有阻力</translation>
    </message>
    <message>
        <source>Torque: not read</source>
        <translation>扭矩：未读取</translation>
    </message>
    <message>
        <source>● Torque on</source>
        <translation>● 扭矩输出</translation>
    </message>
    <message>
        <source>◐ Damping</source>
        <translation>◐ 阻尼</translation>
    </message>
    <message>
        <source>○ Torque off</source>
        <translation>○ 扭矩关闭</translation>
    </message>
    <message>
        <source>On: the servo holds where it stands now, whatever its mode. Off: the shaft is free.</source>
        <translation>打开：无论何种模式，舵机都保持在当前位置。关闭：输出轴自由。</translation>
    </message>
    <message>
        <source>More of torque</source>
        <translation>更多扭矩选项</translation>
    </message>
    <message>
        <source>Damping and centring</source>
        <translation>阻尼与中位校准</translation>
    </message>
</context>
<context>
    <name>ui::CursorTable</name>
    <message>
        <source>Copy readings</source>
        <translation>复制读数</translation>
    </message>
    <message>
        <source>Copy the whole table, for a spreadsheet</source>
        <translation>复制整个表格，可粘贴到电子表格</translation>
    </message>
    <message>
        <source>Readings at the cursors</source>
        <translation>光标读数</translation>
    </message>
    <message>
        <source>Values at the cursors A and B and of the samples between them</source>
        <translation>光标 A、B 处的数值，以及两者之间各采样的统计</translation>
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
        <source>Of the least-squares line through the samples, per second</source>
        <translation>采样点最小二乘直线的斜率，每秒</translation>
    </message>
    <message>
        <source>Standard deviation of the samples themselves</source>
        <translation>采样本身的标准差</translation>
    </message>
    <message>
        <source>Samples between A and B; ≈: part of them is kept as extremes only</source>
        <translation>A、B 之间的采样数；≈：其中一部分只保留了极值</translation>
    </message>
    <message>
        <source>No cursors. C in the chart shows them; drag A and B.</source>
        <translation>未显示光标。在曲线图中按 C 显示，拖动 A 和 B。</translation>
    </message>
    <message>
        <source>A %1 · B %2 · Δt %3</source>
        <translation>A %1 · B %2 · Δt %3</translation>
    </message>
</context>
<context>
    <name>ui::DryRunDialog</name>
    <message>
        <source>What would be written</source>
        <translation>将要写入的内容</translation>
    </message>
    <message>
        <source>ID %1: nothing. Every ticked row is already so.</source>
        <translation>ID %1：无需写入。已勾选的行都已一致。</translation>
    </message>
    <message>
        <source>ID %1, in this order. Every row is read back; nothing has been written yet.</source>
        <translation>ID %1，按此顺序写入，每一行都会回读；目前尚未写入任何内容。</translation>
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
        <translation>寄存器</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>改为</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the steps as text</source>
        <translation>把步骤复制为文本</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close; nothing is written</source>
        <translation>关闭，不写入任何内容</translation>
    </message>
    <message>
        <source>The snapshot is of another model: %1.</source>
        <translation>此快照来自其他型号：%1。</translation>
    </message>
    <message>
        <source>✗ %1: %2</source>
        <translation>✗ %1：%2</translation>
    </message>
    <message>
        <source>%1, not selected: %2</source>
        <translation>%1（未选中）：%2</translation>
    </message>
</context>
<context>
    <name>ui::EnumEditor</name>
    <message>
        <source>not documented</source>
        <translation>资料中没有说明</translation>
    </message>
    <message>
        <source>Choose a value. %1</source>
        <translation>选择一个值。%1</translation>
    </message>
</context>
<context>
    <name>ui::ErrorHistogram</name>
    <message>
        <source>No steady error has been measured yet.</source>
        <translation>尚未测得静差。</translation>
    </message>
    <message>
        <source>Legs: %1. From %2 to %3 %4, mean %5 %4.</source>
        <translation>程数：%1。%2 至 %3 %4，平均 %5 %4。</translation>
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
        <source>Error at target</source>
        <translation>到位误差</translation>
    </message>
    <message>
        <source>%1 to %2 %3: %4 of %5 legs (%6 %)</source>
        <translation>%1 至 %2 %3：%4 / %5 程（%6 %）</translation>
    </message>
</context>
<context>
    <name>ui::HelpWindow</name>
    <message>
        <source>ServoDesk — help</source>
        <translation>ServoDesk — 帮助</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
</context>
<context>
    <name>ui::HistoryPage</name>
    <message>
        <source>This computer</source>
        <translation>本机</translation>
    </message>
    <message>
        <source>Server: all benches</source>
        <translation>服务器：所有工位</translation>
    </message>
    <message>
        <source>All servos</source>
        <translation>所有舵机</translation>
    </message>
    <message>
        <source>All registers</source>
        <translation>所有寄存器</translation>
    </message>
    <message>
        <source>Server: %1</source>
        <translation>服务器：%1</translation>
    </message>
    <message>
        <source>Table at this moment</source>
        <translation>此刻的内存表</translation>
    </message>
    <message>
        <source>Earlier tests…</source>
        <translation>以往测试…</translation>
    </message>
    <message>
        <source>Open snapshot</source>
        <translation>打开快照</translation>
    </message>
    <message>
        <source>The servo&apos;s table as it was just before this write, to compare and restore</source>
        <translation>此次写入之前舵机的内存表，可比较和恢复</translation>
    </message>
    <message>
        <source>Reports and comparisons of kept tests</source>
        <translation>以往测试的报告与比较</translation>
    </message>
    <message>
        <source>Compare it and restore from it</source>
        <translation>与之比较并从中恢复</translation>
    </message>
    <message>
        <source>Asking…</source>
        <translation>正在查询…</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>没有记录</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 行</translation>
    </message>
    <message>
        <source>%1 rows and more</source>
        <translation>%1 行以上</translation>
    </message>
    <message>
        <source>%1: sending %2 rows</source>
        <translation>%1：正在发送 %2 行</translation>
    </message>
    <message>
        <source>%1: sending</source>
        <translation>%1：正在发送</translation>
    </message>
    <message>
        <source>✔ %1 is up to date</source>
        <translation>✔ %1 已是最新</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史记录</translation>
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
        <source>What is listed</source>
        <translation>列出的内容</translation>
    </message>
    <message>
        <source>List</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>Only what concerns this servo</source>
        <translation>只看这个舵机</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>寄存器</translation>
    </message>
    <message>
        <source>Only writes to this register</source>
        <translation>只看写入此寄存器的记录</translation>
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
        <source>Last year</source>
        <translation>最近一年</translation>
    </message>
    <message>
        <source>From … until …</source>
        <translation>自定义时间段</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Only what happened in this time</source>
        <translation>只看这段时间</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>The first day</source>
        <translation>第一天</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>到</translation>
    </message>
    <message>
        <source>The last day</source>
        <translation>最后一天</translation>
    </message>
    <message>
        <source>Only trouble</source>
        <translation>只看问题</translation>
    </message>
    <message>
        <source>Writes that did not end well, alarms that are not over</source>
        <translation>未成功的写入、尚未消失的报警</translation>
    </message>
    <message>
        <source>Servos carry no serial number. What belongs together is told by model, firmware, ID and the label you give: two alike without a label cannot be told apart.</source>
        <translation>舵机没有序列号。只能凭型号、固件、ID 和您给的标签判断是否同一个舵机：两个相同且没有标签的舵机无法区分。</translation>
    </message>
    <message>
        <source>Label…</source>
        <translation>标签…</translation>
    </message>
    <message>
        <source>Give the servo or the snapshot a name</source>
        <translation>给舵机或快照起名</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Save the list, as it is filtered, as CSV or JSON</source>
        <translation>把筛选后的列表保存为 CSV 或 JSON</translation>
    </message>
    <message>
        <source>Server…</source>
        <translation>服务器…</translation>
    </message>
    <message>
        <source>Send copies of the history to a PostgreSQL server, and look at those of all benches</source>
        <translation>把历史记录副本发送到 PostgreSQL 服务器，并查看所有工位的记录</translation>
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
        <source>Some registers are not known for that moment.</source>
        <translation>那一刻有些寄存器的值未知。</translation>
    </message>
    <message>
        <source>What changed them was not recorded: %1.</source>
        <translation>改变它们的操作没有记录：%1。</translation>
    </message>
    <message>
        <source>They are left alone when the table is restored.</source>
        <translation>恢复时不改动它们。</translation>
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
        <source>%1 rows saved: %2</source>
        <translation>已保存 %1 行：%2</translation>
    </message>
    <message>
        <source>Newest first; each row&apos;s own hint has all of it</source>
        <translation>最新的在最前；每行的提示有全部内容</translation>
    </message>
    <message>
        <source>⚠ %1: what is written now is sent later.</source>
        <translation>⚠ %1：现在写入的内容将稍后发送。</translation>
    </message>
    <message>
        <source>History server</source>
        <translation>历史记录服务器</translation>
    </message>
    <message>
        <source>The servo had ID %1 at that moment.</source>
        <translation>那一刻舵机的 ID 是 %1。</translation>
    </message>
    <message>
        <source>Its ID was changed on %1.</source>
        <translation>它的 ID 于 %1 更改。</translation>
    </message>
    <message>
        <source>What was written to it with that ID is in the history of servo ID %1, not in this table.</source>
        <translation>以该 ID 进行的写入在 ID %1 舵机的历史记录中，不在此内存表中。</translation>
    </message>
</context>
<context>
    <name>ui::HistoryServerDialog</name>
    <message>
        <source>History server</source>
        <translation>历史记录服务器</translation>
    </message>
    <message>
        <source>Writes, snapshots, labels and tests of this bench are copied to a PostgreSQL server, where all benches can be looked at together. This computer keeps everything itself; a server that is away never stops a write.</source>
        <translation>本工位的写入、快照、标签和测试会复制到 PostgreSQL 服务器，可在那里一起查看所有工位。本机自己保存全部内容；服务器连接不上绝不影响写入。</translation>
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
        <source>Connection string of PostgreSQL; empty: no copies are sent</source>
        <translation>PostgreSQL 的连接字符串；留空则不发送副本</translation>
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
        <source>How others find its history on the server</source>
        <translation>他人在服务器上凭此名称找到本工位的记录</translation>
    </message>
    <message>
        <source>The server is set by SERVODESK_HISTORY_SERVER.</source>
        <translation>服务器由环境变量 SERVODESK_HISTORY_SERVER 指定。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Keep this and begin to send</source>
        <translation>保存并开始发送</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>不作更改</translation>
    </message>
    <message>
        <source>Store the password in ~/.pgpass, not in the string. A server on another computer must use TLS with a valid certificate; to change that, add ?sslmode=… to the string.</source>
        <translation>密码请存放在 ~/.pgpass 中，不要写在连接字符串里。其他计算机上的服务器必须使用带有效证书的 TLS；如需更改，请在字符串后加 ?sslmode=…。</translation>
    </message>
</context>
<context>
    <name>ui::LimitsDialog</name>
    <message>
        <source>Give these limits a name: the report says by which ones a servo was judged.</source>
        <translation>请为限值命名：报告中会写明舵机按哪组限值判定。</translation>
    </message>
    <message>
        <source>The tolerance must be a number of steps above 0, or empty.</source>
        <translation>允差必须是大于 0 的步数，或留空。</translation>
    </message>
    <message>
        <source>Without a line every servo would pass: add one.</source>
        <translation>没有任何限值行时所有舵机都会合格：请添加一行。</translation>
    </message>
    <message>
        <source>Line %1, %2: %3</source>
        <translation>第 %1 行，%2：%3</translation>
    </message>
    <message>
        <source>Judge by these limits from now on</source>
        <translation>今后按这些限值判定</translation>
    </message>
    <message>
        <source>Keep these limits in a file</source>
        <translation>将这些限值保存到文件</translation>
    </message>
    <message>
        <source>Keep the limits</source>
        <translation>保存限值</translation>
    </message>
    <message>
        <source>Limits from a file</source>
        <translation>从文件读取限值</translation>
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
        <source>Kept in %1</source>
        <translation>已保存到 %1</translation>
    </message>
    <message>
        <source>Limits of the sweep test</source>
        <translation>扫描测试的限值</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Stands in the report</source>
        <translation>写入报告</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>Models or series these are for, with commas between them; empty: any</source>
        <translation>适用的型号或系列，以逗号分隔；留空表示任意</translation>
    </message>
    <message>
        <source>Tolerance, steps</source>
        <translation>到位允差，步</translation>
    </message>
    <message>
        <source>So near its target a servo has reached it; empty: as is usual for its family</source>
        <translation>距目标在此范围内即为到位；留空则用该系列的默认值</translation>
    </message>
    <message>
        <source>any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>as usual for the family</source>
        <translation>该系列默认值</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>A line a figure; type, or press F2, to change it</source>
        <translation>每行一个指标；直接输入或按 F2 修改</translation>
    </message>
    <message>
        <source>Add a line</source>
        <translation>添加一行</translation>
    </message>
    <message>
        <source>A limit for one more figure</source>
        <translation>为另一项指标设限值</translation>
    </message>
    <message>
        <source>Remove the line</source>
        <translation>删除该行</translation>
    </message>
    <message>
        <source>The chosen figure is no longer judged</source>
        <translation>所选指标不再判定</translation>
    </message>
    <message>
        <source>Built-in values</source>
        <translation>内置限值</translation>
    </message>
    <message>
        <source>The limits that come with the program</source>
        <translation>程序自带的限值</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>读取…</translation>
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
        <source>The limits stay as they were</source>
        <translation>限值保持不变</translation>
    </message>
    <message>
        <source>Use these limits</source>
        <translation>使用这些限值</translation>
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
        <source>A limit is never negative: errors are judged without their sign.</source>
        <translation>限值不能为负：误差按绝对值判定。</translation>
    </message>
    <message>
        <source>Give a number to warn at, one to fail at, or both.</source>
        <translation>请填写警告限值、不合格限值，或两者。</translation>
    </message>
    <message>
        <source>It would fail before it warns: change one of the two numbers.</source>
        <translation>会先判不合格再警告：请修改其中一个数值。</translation>
    </message>
    <message>
        <source>This figure has a limit in the same direction already.</source>
        <translation>该指标在同一方向已有限值。</translation>
    </message>
    <message>
        <source>A number in the unit of the figure; empty: no such limit</source>
        <translation>以该指标的单位填写数值；留空表示无此限值</translation>
    </message>
    <message>
        <source>Must be</source>
        <translation>要求</translation>
    </message>
    <message>
        <source>Only for a sine; other tests leave this line out</source>
        <translation>仅用于正弦；其他测试忽略此项</translation>
    </message>
    <message>
        <source>Only for a sine (% of its amplitude) and random targets (% of the range); other tests leave this line out</source>
        <translation>仅用于正弦（占幅值的百分比）和随机目标（占行程范围的百分比）；其他测试忽略此项</translation>
    </message>
</context>
<context>
    <name>ui::LinkErrorBanner</name>
    <message>
        <source>The connection to %1 broke off.</source>
        <translation>与 %1 的连接已断开。</translation>
    </message>
    <message>
        <source>%1 was unplugged.</source>
        <translation>%1 已被拔出。</translation>
    </message>
    <message>
        <source>Plug it in again: then you can go on here. What was being written is in the journal, and is looked at first.</source>
        <translation>重新插入后可在此继续。正在写入的内容已记入日志，连接后首先检查。</translation>
    </message>
    <message>
        <source>The adapter is back at %1.</source>
        <translation>适配器已重新出现在 %1。</translation>
    </message>
    <message>
        <source>Connect again to go on with its servos; nothing is written.</source>
        <translation>重新连接即可继续使用其舵机；不写入任何内容。</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Open the port once more, as the fields above say</source>
        <translation>按上方设置再次打开串口</translation>
    </message>
    <message>
        <source>Connect again</source>
        <translation>重新连接</translation>
    </message>
    <message>
        <source>Open the port again with the same settings and search it</source>
        <translation>用相同设置重新打开串口并搜索</translation>
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
        <source>Servos leave the factory without parity</source>
        <translation>舵机出厂时无校验</translation>
    </message>
    <message>
        <source>Time-out</source>
        <translation>超时</translation>
    </message>
    <message>
        <source>How long to wait for an answer beyond its time on the wire. Auto: as long as this adapter has shown to need</source>
        <translation>除线上传输时间外等待应答的时间。自动：按该适配器的实际表现</translation>
    </message>
    <message>
        <source>Modbus silence</source>
        <translation>Modbus 帧间隔</translation>
    </message>
    <message>
        <source>Pause between Modbus frames. Auto: as the standard says for the rate</source>
        <translation>Modbus 帧之间的停顿。自动：按标准规定</translation>
    </message>
    <message>
        <source>Retries</source>
        <translation>重试次数</translation>
    </message>
    <message>
        <source>How often a lost question is asked again, where it may be repeated</source>
        <translation>应答丢失时重新询问的次数（仅限可重复的指令）</translation>
    </message>
</context>
<context>
    <name>ui::LockBadge</name>
    <message>
        <source>no EPROM lock</source>
        <translation>无 EPROM 锁</translation>
    </message>
    <message>
        <source>This family has no lock: the servo keeps every setting at once.</source>
        <translation>该系列没有锁标志：每次设置都立即保存。</translation>
    </message>
    <message>
        <source>EPROM lock not read</source>
        <translation>锁标志未读取</translation>
    </message>
    <message>
        <source>The lock flag has not been read. Choose Read all.</source>
        <translation>还没有读取锁标志。请点“读取全部”。</translation>
    </message>
    <message>
        <source>EPROM locked</source>
        <translation>EPROM 已上锁</translation>
    </message>
    <message>
        <source>The lock is closed. ServoDesk opens it for a write and closes it afterwards.</source>
        <translation>已上锁。ServoDesk 写入时自动解锁，写完重新上锁。</translation>
    </message>
    <message>
        <source>EPROM open, by ServoDesk</source>
        <translation>EPROM 已解锁（ServoDesk 打开）</translation>
    </message>
    <message>
        <source>ServoDesk opened the lock for a write that has not ended. If nothing is being written, look at the interrupted writes.</source>
        <translation>ServoDesk 为一次尚未结束的写入打开了锁。若当前没有写入，请查看中断的写入。</translation>
    </message>
    <message>
        <source>EPROM open, not by ServoDesk</source>
        <translation>EPROM 已解锁（非 ServoDesk 打开）</translation>
    </message>
    <message>
        <source>Another program left the lock open: every write of anybody is kept for good. Close it when you have finished there.</source>
        <translation>其他程序没有上锁：任何写入都会永久保存。在那边完成后请上锁。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>上锁</translation>
    </message>
    <message>
        <source>Close the EPROM lock</source>
        <translation>EPROM 上锁</translation>
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
        <source>Memory</source>
        <translation>编程</translation>
    </message>
    <message>
        <source>The servo&apos;s memory table: every setting, read and written safely</source>
        <translation>舵机内存表：安全地读取和写入每一项设置</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>Esc   Torque off — all</source>
        <translation>Esc   全部卸力</translation>
    </message>
    <message>
        <source>Torque off for all servos</source>
        <translation>全部舵机卸力</translation>
    </message>
    <message>
        <source>Switch between English and Chinese</source>
        <translation>切换中文和英文</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Switch between light and dark</source>
        <translation>切换浅色和深色</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Drive the servo and watch it</source>
        <translation>驱动舵机并观察</translation>
    </message>
    <message>
        <source>Sweep test</source>
        <translation>扫描测试</translation>
    </message>
    <message>
        <source>Run servos through their paces and say whether they are good</source>
        <translation>让舵机走一遍测试，判定是否合格</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>阶跃响应</translation>
    </message>
    <message>
        <source>See how a servo answers a step, and try other gains</source>
        <translation>查看舵机对阶跃的响应，并试用其他增益</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>快照</translation>
    </message>
    <message>
        <source>Save, compare and restore what servos keep</source>
        <translation>保存、比较和恢复舵机里的设置</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史记录</translation>
    </message>
    <message>
        <source>What was ever written, saved, tested and alarmed</source>
        <translation>所有写入、快照、测试和报警的记录</translation>
    </message>
    <message>
        <source>Commissioning</source>
        <translation>批量设置</translation>
    </message>
    <message>
        <source>Set up servos plugged in one after the other</source>
        <translation>逐个接上并设置舵机</translation>
    </message>
    <message>
        <source>Switch between English and Chinese. No font for Chinese is installed (Debian: fonts-noto-cjk).</source>
        <translation>切换中英文。系统没有安装中文字体（Debian：fonts-noto-cjk）。</translation>
    </message>
</context>
<context>
    <name>ui::MemoryOutput</name>
    <message>
        <source>Table for spreadsheets (*.csv)</source>
        <translation>电子表格 (*.csv)</translation>
    </message>
    <message>
        <source>Page to read or print (*.html)</source>
        <translation>可阅读或打印的网页 (*.html)</translation>
    </message>
    <message>
        <source>Export the memory table</source>
        <translation>导出内存表</translation>
    </message>
</context>
<context>
    <name>ui::MemoryPage</name>
    <message>
        <source>The table was written to %1.</source>
        <translation>内存表已写入 %1。</translation>
    </message>
    <message>
        <source>Choose a servo at the left to see its memory table. Choosing reads it and writes nothing.</source>
        <translation>请在左侧选择舵机以查看内存表。选择时只读取，不写入。</translation>
    </message>
    <message>
        <source>This servo answers, but does not say what it is, so there is no table for it. Search again, or check whether two servos share the ID.</source>
        <translation>该舵机有应答，但读不到型号信息，因此没有内存表。请重新搜索，或检查是否有两个舵机 ID 相同。</translation>
    </message>
    <message>
        <source>No register fits the filter.</source>
        <translation>没有符合筛选条件的参数。</translation>
    </message>
    <message>
        <source>The firmware of this servo is not known.</source>
        <translation>该舵机的固件版本未知。</translation>
    </message>
    <message>
        <source>No public memory table fits it, so a write could do damage.</source>
        <translation>没有与之相符的公开内存表，写入可能造成损坏。</translation>
    </message>
    <message>
        <source>Identity and measurements are shown. Writing becomes possible with a model file.</source>
        <translation>只显示身份信息和测量值。添加型号文件后才能写入。</translation>
    </message>
    <message>
        <source>Memory table</source>
        <translation>内存表</translation>
    </message>
    <message>
        <source>Enter or a double click changes a value; nothing is written before Enter is pressed again</source>
        <translation>回车或双击可修改数值；再次按回车之前不会写入</translation>
    </message>
</context>
<context>
    <name>ui::MemoryToolbar</name>
    <message>
        <source>all groups</source>
        <translation>全部分组</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>fastest</source>
        <translation>最快</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>find a register</source>
        <translation>查找参数</translation>
    </message>
    <message>
        <source>Find a register</source>
        <translation>查找参数</translation>
    </message>
    <message>
        <source>Address, name, key or a word of the help; several words must all occur</source>
        <translation>地址、名称、键名或说明中的词；多个词须同时出现</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Show every register</source>
        <translation>显示全部参数</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>已改</translation>
    </message>
    <message>
        <source>Show what differs from the first reading of this session</source>
        <translation>显示与本次首次读取不同的参数</translation>
    </message>
    <message>
        <source>≠ default</source>
        <translation>≠ 默认</translation>
    </message>
    <message>
        <source>Show what differs from the factory&apos;s value, where that is known</source>
        <translation>显示与已知出厂值不同的参数</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>分组</translation>
    </message>
    <message>
        <source>Show one part of the memory</source>
        <translation>只显示内存的一部分</translation>
    </message>
    <message>
        <source>raw</source>
        <translation>原始值</translation>
    </message>
    <message>
        <source>Raw numbers first, and for typing</source>
        <translation>原始值在前，并用于输入</translation>
    </message>
    <message>
        <source>physical</source>
        <translation>物理值</translation>
    </message>
    <message>
        <source>Values with their unit first, and for typing</source>
        <translation>带单位的物理值在前，并用于输入</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>刷新</translation>
    </message>
    <message>
        <source>Live reading</source>
        <translation>实时读取</translation>
    </message>
    <message>
        <source>How often the visible rows are read again; writes nothing</source>
        <translation>可见行的重新读取频率；不写入</translation>
    </message>
    <message>
        <source>Explain this row</source>
        <translation>本行说明</translation>
    </message>
    <message>
        <source>Show everything that is known about the selected row</source>
        <translation>显示所选行的全部说明</translation>
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
        <source>Everything that was reported since the start</source>
        <translation>启动以来的全部消息</translation>
    </message>
    <message>
        <source>Nothing has happened yet.</source>
        <translation>尚无消息。</translation>
    </message>
</context>
<context>
    <name>ui::NoteDialog</name>
    <message>
        <source>Label and note</source>
        <translation>标签和备注</translation>
    </message>
    <message>
        <source>&amp;Label</source>
        <translation>标签(&amp;L)</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>A short name, shown in lists: “reference, tested”</source>
        <translation>列表中显示的简短名称，例如“参考，已测试”</translation>
    </message>
    <message>
        <source>&amp;Note</source>
        <translation>备注(&amp;N)</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Anything worth knowing later</source>
        <translation>以后值得知道的任何内容</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Keep label and note</source>
        <translation>保存标签和备注</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>不作更改</translation>
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
        <source>turns since connecting: %1 (not certain)</source>
        <translation>连接后圈数：%1（不确定）</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Position and goal</source>
        <translation>位置和目标</translation>
    </message>
</context>
<context>
    <name>ui::OperateStatus</name>
    <message>
        <source>Not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>Answers: %1 · time-outs: %2 · wrong checksums: %3</source>
        <translation>应答：%1 · 超时：%2 · 校验错误：%3</translation>
    </message>
    <message>
        <source>Time-out</source>
        <translation>通信超时</translation>
    </message>
    <message>
        <source>Communication fine</source>
        <translation>通信正常</translation>
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
        <source> — over</source>
        <translation> — 已解除</translation>
    </message>
    <message>
        <source>First seen %1, %2 times</source>
        <translation>首次出现 %1，共 %2 次</translation>
    </message>
    <message>
        <source>Worked out from its limits: it reports no faults</source>
        <translation>由限值推算：该舵机不上报故障</translation>
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
        <source>%1 ms</source>
        <translation>%1 毫秒</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>value age %1 · %2 Hz</source>
        <translation>数据 %1前 · %2 Hz</translation>
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
        <source>Faults that are over go from here; the others stay</source>
        <translation>已解除的故障从此处消失，其余保留</translation>
    </message>
    <message>
        <source>How old the newest value is, and how many readings came in the last second</source>
        <translation>最新数据的时间，以及最近一秒的读取次数</translation>
    </message>
    <message>
        <source>Age and rate</source>
        <translation>数据时间和频率</translation>
    </message>
    <message>
        <source>moving: not known</source>
        <translation>移动：未知</translation>
    </message>
    <message>
        <source>Unreadable answers</source>
        <translation>应答无法识别</translation>
    </message>
    <message>
        <source>alarms: –</source>
        <translation>报警：–</translation>
    </message>
    <message>
        <source>Not known: the servo does not answer, or what tells of faults has not been read</source>
        <translation>未知：舵机没有应答，或故障状态尚未读取</translation>
    </message>
</context>
<context>
    <name>ui::PortDialog</name>
    <message>
        <source>Another port</source>
        <translation>其他端口</translation>
    </message>
    <message>
        <source>Path of a port, or address of a TCP bridge:</source>
        <translation>串口路径或 TCP 转接器地址：</translation>
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
        <source>Take this port; it is opened with Connect</source>
        <translation>选用此端口；点“连接”打开</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Keep the port chosen before</source>
        <translation>保留原来选择的端口</translation>
    </message>
</context>
<context>
    <name>ui::PortPicker</name>
    <message>
        <source>Description: %1</source>
        <translation>描述：%1</translation>
    </message>
    <message>
        <source>Vendor: %1</source>
        <translation>厂商：%1</translation>
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
        <source>%1 (not there now)</source>
        <translation>%1（当前未接入）</translation>
    </message>
    <message>
        <source>%1 is not plugged in; it is chosen all the same</source>
        <translation>%1 当前未插入，选择仍然保留</translation>
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
        <source>Type a path such as /dev/ttyUSB0 or an address such as tcp://192.168.1.20:4000</source>
        <translation>输入路径（如 /dev/ttyUSB0）或地址（如 tcp://192.168.1.20:4000）</translation>
    </message>
    <message>
        <source>Choose a port</source>
        <translation>请选择端口</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Where the servos are connected</source>
        <translation>舵机所接的端口</translation>
    </message>
</context>
<context>
    <name>ui::PressGuard</name>
    <message>
        <source>Ignored: this control moved just now. Press it again.</source>
        <translation>已忽略：此控件刚刚移动了位置。请再按一次。</translation>
    </message>
</context>
<context>
    <name>ui::RateChooser</name>
    <message>
        <source>Rates to search</source>
        <translation>要搜索的波特率</translation>
    </message>
    <message>
        <source>Tick the rates to search; the space bar ticks too</source>
        <translation>勾选要搜索的波特率；也可按空格键勾选</translation>
    </message>
</context>
<context>
    <name>ui::RecordDialog</name>
    <message>
        <source>Name a file first.</source>
        <translation>请先指定文件。</translation>
    </message>
    <message>
        <source>Table, for spreadsheets (*.csv)</source>
        <translation>表格，用于电子表格 (*.csv)</translation>
    </message>
    <message>
        <source>JSON lines, for programs (*.jsonl)</source>
        <translation>JSON 行，用于程序 (*.jsonl)</translation>
    </message>
    <message>
        <source>Record to</source>
        <translation>记录到</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>*.csv: a table; *.jsonl: one JSON object a line</source>
        <translation>*.csv：表格；*.jsonl：每行一个 JSON 对象</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Choose folder and name</source>
        <translation>选择文件夹和名称</translation>
    </message>
    <message>
        <source>The curves of the chart</source>
        <translation>图中的曲线</translation>
    </message>
    <message>
        <source>Only what is shown is written</source>
        <translation>只写入显示的内容</translation>
    </message>
    <message>
        <source>Everything that is read</source>
        <translation>所有读取的数据</translation>
    </message>
    <message>
        <source>Also what the chart does not show</source>
        <translation>包括图中未显示的内容</translation>
    </message>
    <message>
        <source>End by itself after</source>
        <translation>自动结束于</translation>
    </message>
    <message>
        <source>Otherwise it goes on until it is stopped</source>
        <translation>否则一直记录到停止为止</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Seconds from the first row</source>
        <translation>从第一行起的秒数</translation>
    </message>
    <message>
        <source>Begin now</source>
        <translation>现在开始</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Record nothing</source>
        <translation>不记录</translation>
    </message>
    <message>
        <source>There is such a file already. Press Record once more to replace it, or give another name.</source>
        <translation>该文件已存在。再按一次“记录”将替换它，或换一个名称。</translation>
    </message>
</context>
<context>
    <name>ui::RegisterDelegate</name>
    <message>
        <source>“%1” was not written: the cell was left without Enter.</source>
        <translation>“%1”没有写入：离开单元格时没有按回车。</translation>
    </message>
</context>
<context>
    <name>ui::RegisterEditor</name>
    <message>
        <source>Enter writes, Esc cancels.</source>
        <translation>回车写入，Esc 取消。</translation>
    </message>
    <message>
        <source>Esc takes torque off the whole bus and shows the present value again.</source>
        <translation>按 Esc 让整条总线卸力，并重新显示当前值。</translation>
    </message>
    <message>
        <source>Enter sends it.</source>
        <translation>按回车发送。</translation>
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
        <source>Help of the register</source>
        <translation>参数说明</translation>
    </message>
    <message>
        <source>What the selected register does, and a place to change it</source>
        <translation>所选参数的作用，也可在此修改</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>Write this value, read it back, and keep it where the register can</source>
        <translation>写入该值并回读；可保存的参数断电后保留</translation>
    </message>
    <message>
        <source>Write temporarily</source>
        <translation>临时写入</translation>
    </message>
    <message>
        <source>Try the value: the lock stays closed, and it is lost at power-off</source>
        <translation>试用该值：不解锁，断电后丢失</translation>
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
        <source>Stand still</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>Play the recording</source>
        <translation>播放记录</translation>
    </message>
    <message>
        <source>Place in the recording</source>
        <translation>记录中的位置</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>How fast it is played</source>
        <translation>播放速度</translation>
    </message>
    <message>
        <source>Time in the recording</source>
        <translation>记录中的时间</translation>
    </message>
</context>
<context>
    <name>ui::RunsDialog</name>
    <message>
        <source>Earlier tests</source>
        <translation>以往测试</translation>
    </message>
    <message>
        <source>Model, firmware, label, note, operator or port</source>
        <translation>型号、固件、标签、备注、操作员或端口</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Show only tests with this text</source>
        <translation>仅显示含此文字的测试</translation>
    </message>
    <message>
        <source>One row for each servo of a test, newest first</source>
        <translation>测试中每个舵机一行，最新的在前</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>保存报告…</translation>
    </message>
    <message>
        <source>Save the report of the selected test as a page</source>
        <translation>将所选测试的报告保存为网页</translation>
    </message>
    <message>
        <source>Compare two</source>
        <translation>对比两项</translation>
    </message>
    <message>
        <source>Hold two selected tests against each other; the one marked as reference, else the older one, is A</source>
        <translation>对比所选的两次测试；标为参考的为 A，否则较早的为 A</translation>
    </message>
    <message>
        <source>Label…</source>
        <translation>标签…</translation>
    </message>
    <message>
        <source>Give the servo in the selected test a name: servos carry no serial number</source>
        <translation>为所选测试中的舵机命名：舵机没有序列号</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>删除…</translation>
    </message>
    <message>
        <source>Delete the selected tests from the history</source>
        <translation>从历史中删除所选测试</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>关闭此窗口</translation>
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
        <source>This servo is no longer what others are held against</source>
        <translation>不再以此舵机作为对比标准</translation>
    </message>
    <message>
        <source>Hold later tests of this model against this servo; a model has one reference</source>
        <translation>此型号以后的测试与此舵机对比；每个型号一个参考</translation>
    </message>
    <message>
        <source>No test has been run yet. Tests of the window and of the command line are kept here.</source>
        <translation>还没有测试。窗口和命令行的测试都保存在这里。</translation>
    </message>
    <message>
        <source>No test fits this filter.</source>
        <translation>没有符合筛选条件的测试。</translation>
    </message>
    <message>
        <source>Select two rows to hold one against the other. Servos carry no serial number: who is who is told by model, firmware, ID and your label.</source>
        <translation>选择两行即可对比。舵机没有序列号：只能按型号、固件、ID 和您的标签区分。</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>Page (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Name of this servo, as it is written on it:</source>
        <translation>此舵机的名称（如其上所写）：</translation>
    </message>
    <message>
        <source>Delete these tests: %1?</source>
        <translation>删除所选测试（%1 次）？</translation>
    </message>
    <message>
        <source>Their figures, legs and settings leave the history, those of all servos that were tested together. Reports and readings in files stay.</source>
        <translation>其指标、各程数据和参数将从历史中移除，包括一同测试的所有舵机。文件形式的报告和读数保留。</translation>
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
        <source>Compared with the reference %1 (test %2 of %3):</source>
        <translation>与参考 %1（测试 %2，%3）对比：</translation>
    </message>
    <message>
        <source>no figure differs by a tenth or more</source>
        <translation>没有指标相差十分之一或以上</translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation>%1（模拟）</translation>
    </message>
    <message>
        <source>★ reference</source>
        <translation>★ 参考</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>When</source>
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
    <message>
        <source>This test did not finish, so it cannot be a reference</source>
        <translation>此测试未完成，不能作为参考</translation>
    </message>
    <message>
        <source>The reference %1 (test %2 of %3) is ignored: that test did not finish. Mark one that did under Earlier tests.</source>
        <translation>参考 %1（测试 %2，%3）已忽略：该测试未完成。请在“以往测试”中将已完成的测试设为参考。</translation>
    </message>
    <message>
        <source>ignored: did not finish</source>
        <translation>已忽略：未完成</translation>
    </message>
    <message>
        <source>This servo failed the test, so it cannot be a reference</source>
        <translation>该舵机测试不合格，不能作为参考</translation>
    </message>
    <message>
        <source>ignored: failed</source>
        <translation>已忽略：不合格</translation>
    </message>
</context>
<context>
    <name>ui::SearchPanel</name>
    <message>
        <source>%1 % · servos: %2 · %3 left</source>
        <translation>%1 % · %2 个舵机 · 剩余 %3</translation>
    </message>
    <message>
        <source> · at %1</source>
        <translation> · %1</translation>
    </message>
    <message>
        <source>The search begins …</source>
        <translation>开始搜索…</translation>
    </message>
    <message>
        <source>Stopped after %1 · servos: %2</source>
        <translation>%1后停止 · %2 个舵机</translation>
    </message>
    <message>
        <source>Searched in %1 · servos: %2</source>
        <translation>用时 %1 · %2 个舵机</translation>
    </message>
    <message>
        <source>Some answered late: search again with &quot;wait longer&quot;, there may be more.</source>
        <translation>部分应答迟到：请勾选“延长等待”再搜索，可能还有舵机。</translation>
    </message>
    <message>
        <source>IDs to ask: %1</source>
        <translation>%1 个 ID</translation>
    </message>
    <message>
        <source> · rates: %1</source>
        <translation> · %1 种波特率</translation>
    </message>
    <message>
        <source> · about %1</source>
        <translation> · 约 %1</translation>
    </message>
    <message>
        <source>How long a search takes that finds nobody</source>
        <translation>一个舵机也没有时搜索所需的时间</translation>
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
        <source>Progress of the search</source>
        <translation>搜索进度</translation>
    </message>
    <message>
        <source>How much of the search is done</source>
        <translation>搜索完成了多少</translation>
    </message>
    <message>
        <source>Servos</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>No servo in the list yet. Search the bus.</source>
        <translation>列表中还没有舵机，请搜索总线。</translation>
    </message>
    <message>
        <source>Servos appear here as they are found.</source>
        <translation>搜索到的舵机会显示在这里。</translation>
    </message>
    <message>
        <source>Back to the list</source>
        <translation>返回列表</translation>
    </message>
    <message>
        <source>Not all there? Find out why…</source>
        <translation>没搜全？查找原因…</translation>
    </message>
    <message>
        <source>Show the servos again</source>
        <translation>重新显示舵机</translation>
    </message>
    <message>
        <source>What to look at when servos are missing</source>
        <translation>缺少舵机时应检查什么</translation>
    </message>
    <message>
        <source>Servos that have answered; choosing one reads it and writes nothing. With Ctrl or Shift several are chosen, to move together</source>
        <translation>有应答的舵机；选择只读取，不写入。按住 Ctrl 或 Shift 可选择多个，一起运动</translation>
    </message>
    <message>
        <source>Commissioning is running: its page shows the servos.</source>
        <translation>批量设置正在进行：舵机显示在其页面上。</translation>
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
        <source>First ID to ask</source>
        <translation>从哪个 ID 开始询问</translation>
    </message>
    <message>
        <source>Last ID</source>
        <translation>结束 ID</translation>
    </message>
    <message>
        <source>Last ID to ask</source>
        <translation>询问到哪个 ID</translation>
    </message>
    <message>
        <source>this rate</source>
        <translation>当前波特率</translation>
    </message>
    <message>
        <source>chosen rates</source>
        <translation>所选波特率</translation>
    </message>
    <message>
        <source>all rates</source>
        <translation>全部波特率</translation>
    </message>
    <message>
        <source>Rates</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>At which baud rates to search; the port&apos;s own rate is put back afterwards</source>
        <translation>搜索哪些波特率；结束后恢复串口原来的波特率</translation>
    </message>
    <message>
        <source>The far end of the TCP connection sets the rate</source>
        <translation>波特率由 TCP 连接的另一端决定</translation>
    </message>
    <message>
        <source>Choose rates</source>
        <translation>选择波特率</translation>
    </message>
    <message>
        <source>Tick the rates to search</source>
        <translation>勾选要搜索的波特率</translation>
    </message>
    <message>
        <source>Protocol: as connected</source>
        <translation>协议：与连接相同</translation>
    </message>
    <message>
        <source>All protocols</source>
        <translation>全部协议</translation>
    </message>
    <message>
        <source>Feetech</source>
        <translation>飞特</translation>
    </message>
    <message>
        <source>Modbus</source>
        <translation>Modbus</translation>
    </message>
    <message>
        <source>LX</source>
        <translation>LX</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>协议</translation>
    </message>
    <message>
        <source>In which protocols to ask</source>
        <translation>用哪些协议询问</translation>
    </message>
    <message>
        <source>wait longer</source>
        <translation>延长等待</translation>
    </message>
    <message>
        <source>Wait longer</source>
        <translation>延长等待</translation>
    </message>
    <message>
        <source>Ask silent IDs again with long patience, for adapters that answer late</source>
        <translation>对无应答的 ID 延长等待再问一遍，适用于应答迟缓的适配器</translation>
    </message>
</context>
<context>
    <name>ui::ServoHistoryModel</name>
    <message>
        <source>Not ended: still being written, or interrupted.</source>
        <translation>未结束：正在写入，或已中断。</translation>
    </message>
    <message>
        <source>Begun and taken back: the old value was restored.</source>
        <translation>已开始并撤回：已恢复原值。</translation>
    </message>
    <message>
        <source>Given up: it was never finished or undone.</source>
        <translation>已放弃：既未完成也未撤回。</translation>
    </message>
    <message>
        <source>It did not end as wanted.</source>
        <translation>未按预期结束。</translation>
    </message>
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
</context>
<context>
    <name>ui::ServoHistoryPanel</name>
    <message>
        <source>History of this servo</source>
        <translation>本舵机记录</translation>
    </message>
    <message>
        <source>No write to this servo is known. Servos are told by model, firmware and ID.</source>
        <translation>没有这个舵机的写入记录。舵机凭型号、固件和 ID 区分。</translation>
    </message>
    <message>
        <source>Writes to this servo, newest first, also under its earlier IDs</source>
        <translation>对这个舵机的写入，最新的在前，包括它以前的 ID</translation>
    </message>
    <message>
        <source>Choose a servo at the left to see what was written to it.</source>
        <translation>请在左侧选择舵机，以查看对它的写入。</translation>
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
        <source>Line</source>
        <translation>接口</translation>
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
        <source>The list of all shortcuts</source>
        <translation>全部快捷键列表</translation>
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
        <source>What it does</source>
        <translation>作用</translation>
    </message>
    <message>
        <source>Torque off — all</source>
        <translation>全部卸力</translation>
    </message>
    <message>
        <source>Takes torque off the whole bus at once, whatever is open</source>
        <translation>无论打开了什么，立即让整条总线卸力</translation>
    </message>
    <message>
        <source>Takes torque off the whole bus at once, also from a field of the motion panel, which then shows the present value again; only in a table cell that is being edited, a menu or a dialog does the first Esc cancel that instead; while servos move or are jammed, it stops them from a menu or a dialog as well</source>
        <translation>立即让整条总线卸力，在运动面板的输入框中也是如此，输入框随后重新显示当前值；只有在正在编辑的表格单元格、菜单或对话框中，第一次 Esc 改为取消它们；有舵机正在运动或被卡住时，在菜单或对话框中也会停止</translation>
    </message>
</context>
<context>
    <name>ui::SnapshotBrowser</name>
    <message>
        <source>before a change</source>
        <translation>修改之前</translation>
    </message>
    <message>
        <source>taken</source>
        <translation>手动保存</translation>
    </message>
    <message>
        <source>with all servos</source>
        <translation>整组保存</translation>
    </message>
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
        <source>Whose snapshots</source>
        <translation>哪个舵机的快照</translation>
    </message>
    <message>
        <source>Snapshots of servos like the selected one with its ID, or all there are. Servos carry no serial number: model, firmware and ID are all that can be known</source>
        <translation>与所选舵机型号和 ID 相同的快照，或全部快照。舵机没有序列号：能知道的只有型号、固件和 ID</translation>
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
        <source>Words in model, label, note or file name</source>
        <translation>型号、标签、备注或文件名中的文字</translation>
    </message>
    <message>
        <source>There is none yet. One is taken by itself before the first change to a servo.</source>
        <translation>还没有快照。第一次修改舵机之前会自动保存一份。</translation>
    </message>
    <message>
        <source>%1 servos</source>
        <translation>%1 个舵机</translation>
    </message>
    <message>
        <source>firmware %1, on %2</source>
        <translation>固件 %1，端口 %2</translation>
    </message>
    <message>
        <source>template, %1 rows</source>
        <translation>模板，%1 行</translation>
    </message>
    <message>
        <source>%1, ID %2</source>
        <translation>%1，ID %2</translation>
    </message>
    <message>
        <source>The current one is compared and restored; hold Ctrl to compare more</source>
        <translation>比较和恢复的是当前项；按住 Ctrl 可多选比较</translation>
    </message>
    <message>
        <source>before commissioning</source>
        <translation>批量设置前</translation>
    </message>
</context>
<context>
    <name>ui::SnapshotPane</name>
    <message>
        <source>≠ %1 differ</source>
        <translation>≠ %1 项不同</translation>
    </message>
    <message>
        <source>= no setting differs</source>
        <translation>= 没有不同的设置</translation>
    </message>
    <message>
        <source>= %1 the same</source>
        <translation>= %1 项相同</translation>
    </message>
    <message>
        <source>%1 read-only, %2 missing, %3 not known</source>
        <translation>%1 项只读，%2 项缺少，%3 项未知</translation>
    </message>
    <message>
        <source>%1 others</source>
        <translation>其他 %1 项</translation>
    </message>
    <message>
        <source>Nothing to set differs.</source>
        <translation>没有不同的设置。</translation>
    </message>
    <message>
        <source>All rows</source>
        <translation>所有行</translation>
    </message>
    <message>
        <source>Show the rows that are the same, too, and those that are only read</source>
        <translation>也显示相同的行和只读的行</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>对比列</translation>
    </message>
    <message>
        <source>Compare with the factory default and with other servos, too. More snapshots: hold Ctrl while clicking them</source>
        <translation>同时与出厂默认值和其他舵机比较。按住 Ctrl 点击可选择更多快照</translation>
    </message>
    <message>
        <source>Tables side by side</source>
        <translation>并排的内存表</translation>
    </message>
    <message>
        <source>Space ticks a row; what is ticked is written</source>
        <translation>按空格键勾选一行；勾选的行会被写入</translation>
    </message>
    <message>
        <source>≠ %1 not restored</source>
        <translation>≠ %1 项不恢复</translation>
    </message>
    <message>
        <source>= no setting differed then</source>
        <translation>= 当时没有不同的设置</translation>
    </message>
    <message>
        <source>Nothing to set differed when the servo was last read.</source>
        <translation>上次读取舵机时没有不同的设置。</translation>
    </message>
</context>
<context>
    <name>ui::SnapshotsPage</name>
    <message>
        <source>ID %1 now</source>
        <translation>ID %1 当前</translation>
    </message>
    <message>
        <source>Factory</source>
        <translation>出厂</translation>
    </message>
    <message>
        <source>Default of this model, as far as it is known</source>
        <translation>此型号已知的出厂默认值</translation>
    </message>
    <message>
        <source>Choose a servo in the list, or a snapshot at the left.</source>
        <translation>请在列表中选择舵机，或在左侧选择快照。</translation>
    </message>
    <message>
        <source>The servo&apos;s table is being read.</source>
        <translation>正在读取舵机的内存表。</translation>
    </message>
    <message>
        <source>Choose a snapshot at the left to compare the servo with, or open a file.</source>
        <translation>请在左侧选择要与舵机比较的快照，或打开文件。</translation>
    </message>
    <message>
        <source>Bundle with %1 servos; choose one of them to compare it</source>
        <translation>含 %1 个舵机的整组快照；选择其中一个进行比较</translation>
    </message>
    <message>
        <source>%1 against %2</source>
        <translation>%1 对比 %2</translation>
    </message>
    <message>
        <source>Write ticked rows</source>
        <translation>写入勾选的行</translation>
    </message>
    <message>
        <source>Write 1 ticked row</source>
        <translation>写入勾选的 1 行</translation>
    </message>
    <message>
        <source>Write %1 ticked rows</source>
        <translation>写入勾选的 %1 行</translation>
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
        <source>Torque goes off first and stays off. Limits, mode, gains; the lock last. Every row is read back; Undo stays possible.</source>
        <translation>先关闭扭矩并保持关闭。顺序：限值、模式、增益，最后上锁。每一行都会回读；之后仍可撤销。</translation>
    </message>
    <message>
        <source>Limits, mode, gains; the lock last. Every row is read back; Undo stays possible.</source>
        <translation>顺序：限值、模式、增益，最后上锁。每一行都会回读；之后仍可撤销。</translation>
    </message>
    <message>
        <source>Factory default</source>
        <translation>出厂默认值</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>快照</translation>
    </message>
    <message>
        <source>Take snapshot</source>
        <translation>保存快照</translation>
    </message>
    <message>
        <source>Read the whole table of the selected servo and keep it in the history</source>
        <translation>读取所选舵机的整个内存表并存入历史记录</translation>
    </message>
    <message>
        <source>Open file…</source>
        <translation>打开文件…</translation>
    </message>
    <message>
        <source>Open snapshots, templates or bundles; or drop them here</source>
        <translation>打开快照、模板或整组快照；也可拖放到这里</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>Save, label or delete a snapshot; save all servos</source>
        <translation>保存、标注或删除快照；保存所有舵机</translation>
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
        <translation>把所有舵机保存为整组快照…</translation>
    </message>
    <message>
        <source>Delete from the history…</source>
        <translation>从历史记录中删除…</translation>
    </message>
    <message>
        <source>ID and rate too</source>
        <translation>包括 ID 和波特率</translation>
    </message>
    <message>
        <source>Tick ID and baud rate as well: the servo then answers there. They are written at the very end</source>
        <translation>同时勾选 ID 和波特率：之后舵机在新地址应答。它们最后写入</translation>
    </message>
    <message>
        <source>If a row fails, put all back</source>
        <translation>若有一行失败，全部恢复原值</translation>
    </message>
    <message>
        <source>Otherwise writing ends at the row that fails, and what is written stays</source>
        <translation>否则在失败的那一行停止，已写入的保留</translation>
    </message>
    <message>
        <source>Write the ticked rows that differ, and only those</source>
        <translation>只写入已勾选且不同的行</translation>
    </message>
    <message>
        <source>Dry run…</source>
        <translation>预演…</translation>
    </message>
    <message>
        <source>Show exactly what would be written, in which order</source>
        <translation>准确显示将按什么顺序写入什么</translation>
    </message>
    <message>
        <source>Write the ticked rows to more than one servo</source>
        <translation>把勾选的行写入多个舵机</translation>
    </message>
    <message>
        <source>Save template…</source>
        <translation>保存模板…</translation>
    </message>
    <message>
        <source>Choose rows of this snapshot and save them as a file, for setting other servos</source>
        <translation>选择此快照中的若干行保存为文件，用于设置其他舵机</translation>
    </message>
    <message>
        <source>Save result…</source>
        <translation>保存结果…</translation>
    </message>
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
        <source>Save all servos</source>
        <translation>保存所有舵机</translation>
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
    <message>
        <source>Delete this snapshot?</source>
        <translation>删除此快照？</translation>
    </message>
    <message>
        <source>Delete %1 snapshots?</source>
        <translation>删除 %1 份快照？</translation>
    </message>
    <message>
        <source>They leave the history of this computer. Files stay where they are.</source>
        <translation>将从本机的历史记录中删除。文件保留在原处。</translation>
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
        <source>%1: a wrong value can make the servo unreachable or dangerous.</source>
        <translation>%1：错误的值可能使舵机无法连接或产生危险。</translation>
    </message>
    <message>
        <source>%1 shifts where the servo believes it is.</source>
        <translation>%1 会改变舵机认定的位置。</translation>
    </message>
    <message>
        <source>%1 changes from %2 to %3: the servo answers there afterwards.</source>
        <translation>%1 从 %2 改为 %3：之后舵机在新地址应答。</translation>
    </message>
    <message>
        <source>Write to ID %1?</source>
        <translation>写入 ID %1？</translation>
    </message>
    <message>
        <source>Torque is on: it goes off first and stays off. What the servo holds may drop.</source>
        <translation>扭矩已打开：会先关闭并保持关闭。舵机托住的东西可能掉落。</translation>
    </message>
    <message>
        <source>Write anyway</source>
        <translation>仍然写入</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>1 row written and read back</source>
        <translation>已写入并回读 1 行</translation>
    </message>
    <message>
        <source>%1 rows written and read back</source>
        <translation>已写入并回读 %1 行</translation>
    </message>
    <message>
        <source>Save the result</source>
        <translation>保存结果</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Data (*.json)</source>
        <translation>数据 (*.json)</translation>
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
        <source>%1 is a limit of another model (%2).</source>
        <translation>“%1”是其他型号（%2）的限制。</translation>
    </message>
    <message>
        <source>Not written, or not proven: %1.</source>
        <translation>未写入或未能证实：%1。</translation>
    </message>
    <message>
        <source>ID %1 · not read yet</source>
        <translation>ID %1 · 尚未读取</translation>
    </message>
    <message>
        <source>ID %1 · no answer · read %2</source>
        <translation>ID %1 · 无应答 · 读取于%2</translation>
    </message>
    <message>
        <source>ID %1 · read %2</source>
        <translation>ID %1 · 读取于%2</translation>
    </message>
</context>
<context>
    <name>ui::StepForm</name>
    <message>
        <source>Step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>How far: in steps, or with a unit (30deg); negative: downwards first</source>
        <translation>阶跃大小：步数，或带单位（30deg）；负值表示先向下</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>Where the step begins; empty: where the servo stands, or as near as there is room</source>
        <translation>阶跃的起点；留空：舵机当前位置，或最近的可用位置</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>重复</translation>
    </message>
    <message>
        <source>So many times there and back</source>
        <translation>往返次数</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>From one goal to the next; 0: as long as the step needs</source>
        <translation>从一个目标到下一个目标的时间；0：按阶跃所需自动确定</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Raw or with a unit; empty: as fast as it can. It gets its own value back</source>
        <translation>原始值或带单位；留空：最快。结束后恢复原值</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>where it stands</source>
        <translation>当前位置</translation>
    </message>
    <message>
        <source>as fast as it can</source>
        <translation>最快</translation>
    </message>
    <message>
        <source>as it needs</source>
        <translation>自动</translation>
    </message>
</context>
<context>
    <name>ui::StepGains</name>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>试用</translation>
    </message>
    <message>
        <source>This family has no gains to set.</source>
        <translation>该系列没有可设置的增益。</translation>
    </message>
    <message>
        <source>Choose a servo to see its gains.</source>
        <translation>请选择舵机以查看增益。</translation>
    </message>
    <message>
        <source>%1: value to try</source>
        <translation>%1：试用值</translation>
    </message>
    <message>
        <source>%1 … %2; in force during a trial run only, until it is accepted</source>
        <translation>%1 … %2；仅在试运行期间生效，采用后才永久写入</translation>
    </message>
</context>
<context>
    <name>ui::StepPage</name>
    <message>
        <source>Connect first.</source>
        <translation>请先连接。</translation>
    </message>
    <message>
        <source>Choose a servo in the list.</source>
        <translation>请在列表中选择舵机。</translation>
    </message>
    <message>
        <source>What this servo is, is not known: nothing is moved.</source>
        <translation>无法识别该舵机，不会驱动它。</translation>
    </message>
    <message>
        <source>The search goes on; a run can be started when it has ended.</source>
        <translation>正在搜索；结束后方可运行。</translation>
    </message>
    <message>
        <source>Another test runs.</source>
        <translation>另一项测试正在运行。</translation>
    </message>
    <message>
        <source>It was stopped in an emergency: switch torque on first.</source>
        <translation>已急停：请先打开扭矩输出。</translation>
    </message>
    <message>
        <source>It is in a mode without positions; tick the switch, or change its mode.</source>
        <translation>当前模式没有位置目标；请勾选切换，或更改模式。</translation>
    </message>
    <message>
        <source>Say how far the step is to go.</source>
        <translation>请填写阶跃大小。</translation>
    </message>
    <message>
        <source>Change a value under Try first.</source>
        <translation>请先更改“试用”中的值。</translation>
    </message>
    <message>
        <source>The servo moves. Esc takes torque off all servos.</source>
        <translation>舵机正在运动。按 Esc 关闭所有舵机的扭矩。</translation>
    </message>
    <message>
        <source>The servo will move when you press Run or Try.</source>
        <translation>按“运行”或“试用”后舵机会转动。</translation>
    </message>
    <message>
        <source>The same step with the values under Try, which are put back afterwards: %1</source>
        <translation>用试用值做同样的阶跃，结束后恢复原值：%1</translation>
    </message>
    <message>
        <source>Under Try the values as they are now</source>
        <translation>将试用值恢复为当前值</translation>
    </message>
    <message>
        <source>Write what was accepted over: %1</source>
        <translation>写回采用之前的值：%1</translation>
    </message>
    <message>
        <source>Start the run?</source>
        <translation>开始运行？</translation>
    </message>
    <message>
        <source>ID %1 · %2 gets torque and moves by itself, as fast as it can, until the run has ended.</source>
        <translation>ID %1 · %2 将打开扭矩并以最快速度自行运动，直到运行结束。</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>What the run had set could not be put back.</source>
        <translation>运行时的设置未能恢复。</translation>
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
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>The step with the servo&apos;s own values: it will move</source>
        <translation>用舵机自身的参数做阶跃：舵机会转动</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>试用</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>End the run; the servo holds where it is</source>
        <translation>结束运行；舵机保持在当前位置</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>采用</translation>
    </message>
    <message>
        <source>Write the values under Try for good</source>
        <translation>将试用值永久写入</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>Switch to position mode for the run</source>
        <translation>运行期间切换到位置模式</translation>
    </message>
    <message>
        <source>Until the run has ended, then back again; nothing is kept in the servo for good</source>
        <translation>运行结束后切换回原模式；不会永久保存到舵机</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>运行进度</translation>
    </message>
    <message>
        <source>Afterwards it holds its position with torque on. The same applies if you stop the run or close the window during it.</source>
        <translation>结束后舵机保持位置，扭矩开启。中途停止或关闭窗口也是如此。</translation>
    </message>
    <message>
        <source>It is noted in the journal: when the servo answers again, put it back under Port → Interrupted writes. At power-off the servo forgets it by itself.</source>
        <translation>已写入记录：舵机恢复应答后，请在“端口 → 中断的写入”中恢复原值。断电后，舵机自己会忘掉这些设置。</translation>
    </message>
    <message>
        <source>%1 %2 (own value %3)</source>
        <translation>%1 %2（原值 %3）</translation>
    </message>
    <message>
        <source>Trial values still in the servo: %1.</source>
        <translation>试用值仍在舵机中：%1。</translation>
    </message>
    <message>
        <source>Keep hands and objects out of its way. Esc takes torque off all servos at once.</source>
        <translation>双手和物体请离开舵机的运动范围。按 Esc 立即关闭所有舵机的扭矩。</translation>
    </message>
</context>
<context>
    <name>ui::StepResults</name>
    <message>
        <source>%1, there</source>
        <translation>%1，去程</translation>
    </message>
    <message>
        <source>%1, back</source>
        <translation>%1，回程</translation>
    </message>
    <message>
        <source>own values</source>
        <translation>自身参数</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>步</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>填入“试用”</translation>
    </message>
    <message>
        <source>Put this value into Try; nothing is written</source>
        <translation>将该值放入“试用”；不写入舵机</translation>
    </message>
    <message>
        <source>Save the runs</source>
        <translation>保存运行结果</translation>
    </message>
    <message>
        <source>Responses, in steps towards the target</source>
        <translation>响应曲线（朝目标方向的步数）</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>Which step of each run is shown</source>
        <translation>显示每次运行的哪一次阶跃</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Forget these runs; nothing in the servo changes</source>
        <translation>清除这些运行结果；舵机不受影响</translation>
    </message>
    <message>
        <source>Run measures how the servo answers a step; Try does the same with other gains, lays both over each other, and puts the gains back.</source>
        <translation>“运行”测量舵机的阶跃响应；“试用”用其他增益重复测量，叠加显示，然后恢复原增益。</translation>
    </message>
    <message>
        <source>Step responses over each other</source>
        <translation>阶跃响应叠加图</translation>
    </message>
    <message>
        <source>Figures before and after</source>
        <translation>前后指标对比</translation>
    </message>
    <message>
        <source>Means of all steps of a run, there and back</source>
        <translation>一次运行中所有往返阶跃的平均值</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>指标</translation>
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
        <source>Value</source>
        <translation>数值</translation>
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
        <source>&lt;b&gt;What to try next&lt;/b&gt;</source>
        <translation>&lt;b&gt;下一步建议&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Nothing in these figures asks for another setting.</source>
        <translation>这些指标无需调整参数。</translation>
    </message>
    <message>
        <source>Save these runs as %1</source>
        <translation>将这些运行结果保存为 %1</translation>
    </message>
    <message>
        <source>%1 (broken off)</source>
        <translation>%1（提前结束）</translation>
    </message>
</context>
<context>
    <name>ui::SweepForm</name>
    <message>
        <source>Open a list of targets</source>
        <translation>打开目标列表</translation>
    </message>
    <message>
        <source>Targets, one a line: target,pause in ms (*.csv *.txt)</source>
        <translation>目标列表，每行：目标,停顿毫秒数 (*.csv *.txt)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>To and fro between start and end</source>
        <translation>在起启与结束之间来回</translation>
    </message>
    <message>
        <source>Stairs</source>
        <translation>步进</translation>
    </message>
    <message>
        <source>From start to end in steps, and back the same steps</source>
        <translation>从起启到结束逐步走，再逐步返回</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>双向</translation>
    </message>
    <message>
        <source>The middle is come to from either side: shows hysteresis</source>
        <translation>从两侧到达中间位置：看回差</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>正弦</translation>
    </message>
    <message>
        <source>Goals follow a sine: shows how well it follows</source>
        <translation>目标按正弦变化：看跟随性能</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>随机</translation>
    </message>
    <message>
        <source>Random targets, the same ones for the same number</source>
        <translation>随机目标，同一序号得到同样的目标</translation>
    </message>
    <message>
        <source>List</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>Targets from a file, one a line</source>
        <translation>目标取自文件，每行一个</translation>
    </message>
    <message>
        <source>A raw number, or an angle with its unit: 90deg</source>
        <translation>原始值，或带单位的角度：90deg</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起启</translation>
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
        <source>A raw number of steps, or an angle with its unit: 10deg</source>
        <translation>原始步数，或带单位的角度：10deg</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>周期</translation>
    </message>
    <message>
        <source>Of one whole sine, to the end and back</source>
        <translation>一个完整正弦，去到结束再返回</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>序号</translation>
    </message>
    <message>
        <source>The same number gives the same targets again</source>
        <translation>同一序号再次得到同样的目标</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>A text file: one target a line, and if wished a comma and its pause in milliseconds</source>
        <translation>文本文件：每行一个目标，可再加逗号和停顿毫秒数</translation>
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
        <source>So long it rests where it has arrived</source>
        <translation>到达后停留的时间</translation>
    </message>
    <message>
        <source>From one goal to the next, arrived or not</source>
        <translation>从一个目标到下一个目标，不论是否到达</translation>
    </message>
    <message>
        <source>Ends after</source>
        <translation>结束条件</translation>
    </message>
    <message>
        <source>When the test has run its course</source>
        <translation>测试何时算完成</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>循环次数</translation>
    </message>
    <message>
        <source>One cycle is there and back</source>
        <translation>一个循环为一去一回</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>From the first leg on</source>
        <translation>从第一段行程算起</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>A raw number, or with its unit: 30rpm. Empty: as the servo has it</source>
        <translation>原始值，或带单位：30rpm。留空：用舵机现有值</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>A raw number. Empty: as the servo has it</source>
        <translation>原始值。留空：用舵机现有值</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Travel time of a move in milliseconds. Empty: as fast as the speed says</source>
        <translation>一次运动的时间（毫秒）。留空：由速度决定</translation>
    </message>
    <message>
        <source>Warm-up</source>
        <translation>预热</translation>
    </message>
    <message>
        <source>It moves so long before anything is measured</source>
        <translation>先运动这么久，再开始测量</translation>
    </message>
    <message>
        <source>Afterwards</source>
        <translation>结束后</translation>
    </message>
    <message>
        <source>What the servos do when the test has ended or was stopped</source>
        <translation>测试结束或停止后舵机的状态</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作员</translation>
    </message>
    <message>
        <source>Stands in the report</source>
        <translation>写入报告</translation>
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
        <source>as it is</source>
        <translation>不改变</translation>
    </message>
    <message>
        <source>by speed</source>
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
        <source>A length of time</source>
        <translation>一段时间</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持扭矩</translation>
    </message>
    <message>
        <source>Torque off</source>
        <translation>卸力</translation>
    </message>
    <message>
        <source>Open a list…</source>
        <translation>打开列表…</translation>
    </message>
    <message>
        <source>%1 (targets: %2)</source>
        <translation>%1（目标：%2 个）</translation>
    </message>
    <message>
        <source>Ends early on</source>
        <translation>提前结束</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Over-temperature, overload, voltage: whatever the servo reports</source>
        <translation>过温、过载、电压：舵机报告的任何故障</translation>
    </message>
    <message>
        <source>stall</source>
        <translation>堵转</translation>
    </message>
    <message>
        <source>It stands still away from its target</source>
        <translation>停在离目标较远处不动</translation>
    </message>
    <message>
        <source>first failure</source>
        <translation>首个不合格项</translation>
    </message>
    <message>
        <source>A limit is failed: judged after every cycle</source>
        <translation>超出限值：每个循环后判定</translation>
    </message>
</context>
<context>
    <name>ui::SweepLegsModel</name>
    <message>
        <source>The latest %1 of %2 legs are shown; the CSV and JSON files have all.</source>
        <translation>仅显示最近 %1 程（共 %2 程）；CSV 和 JSON 文件含全部。</translation>
    </message>
    <message>
        <source>readings lost: %1</source>
        <translation>丢失读数：%1</translation>
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
        <translation>%1 小时 %2 分</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 分 %2 秒</translation>
    </message>
    <message>
        <source>Take %1</source>
        <translation>改为 %1</translation>
    </message>
    <message>
        <source>the sine is faster than the servo can turn; it needs a period of at least %1.</source>
        <translation>正弦变化快于舵机能转的速度，周期至少需要 %1。</translation>
    </message>
    <message>
        <source>the longest way takes %1 at this speed: the servo would turn round before it arrives.</source>
        <translation>按此速度，最长行程需要 %1：延时太短，舵机未到达就会折返。</translation>
    </message>
    <message>
        <source>nothing tells how fast it goes, so the delay cannot be judged.</source>
        <translation>无法得知其速度，因此不能判断延时是否够用。</translation>
    </message>
    <message>
        <source>the longest way takes %1 at this speed.</source>
        <translation>按此速度，最长行程需要 %1。</translation>
    </message>
    <message>
        <source>the longest way takes %1 at this speed: the delay is long enough.</source>
        <translation>按此速度，最长行程需要 %1：延时够用。</translation>
    </message>
    <message>
        <source>About %1 in all.</source>
        <translation>全程约 %1。</translation>
    </message>
    <message>
        <source>On the way to the start</source>
        <translation>正在前往起启位置</translation>
    </message>
    <message>
        <source>Warming up; nothing is measured yet</source>
        <translation>预热中，尚未开始测量</translation>
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
        <source>The test is not in the history.</source>
        <translation>测试未能存入历史记录。</translation>
    </message>
    <message>
        <source>It was left in the file %1.</source>
        <translation>已保存在文件 %1。</translation>
    </message>
    <message>
        <source>Connect first: there is no open port.</source>
        <translation>请先连接：尚未打开串口。</translation>
    </message>
    <message>
        <source>The search goes on; the test can be started when it has ended.</source>
        <translation>搜索进行中，结束后才能开始测试。</translation>
    </message>
    <message>
        <source>Choose a servo in the list, or tick one below.</source>
        <translation>请在列表中选择舵机，或在此勾选。</translation>
    </message>
    <message>
        <source>Start the test?</source>
        <translation>开始测试？</translation>
    </message>
    <message>
        <source>These servos get torque and move by themselves until the test has ended: %1</source>
        <translation>以下舵机将上扭矩并自行运动，直到测试结束：%1</translation>
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
        <source>Start the test: the servos will move</source>
        <translation>开始测试：舵机将会运动</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>End the test; the servos hold or are released, as chosen</source>
        <translation>结束测试；舵机按所选保持或释放扭矩</translation>
    </message>
    <message>
        <source>Switch to position mode for the test</source>
        <translation>测试期间切换到位置模式</translation>
    </message>
    <message>
        <source>Until the test has ended, then back again; nothing is kept in the servo for good</source>
        <translation>测试结束后切换回来；舵机中不会永久保存任何改动</translation>
    </message>
    <message>
        <source>Progress of the test</source>
        <translation>测试进度</translation>
    </message>
    <message>
        <source>Torque could not be switched off: %1.</source>
        <translation>未能卸力：%1。</translation>
    </message>
    <message>
        <source>most moves are too short for a verdict: targets count as reached within %1 steps, so moves need at least %2 steps.</source>
        <translation>大多数行程太短，无法得出结论：距目标 %1 步以内即视为到位，因此每个行程至少需要 %2 步。</translation>
    </message>
    <message>
        <source>Held by the emergency stop: %1. Switch torque on first; the Operate page does it for all selected servos.</source>
        <translation>被急停锁定：%1。请先打开扭矩；在操作页可一次打开所有所选舵机的扭矩。</translation>
    </message>
    <message>
        <source>Afterwards their torque is off. The same applies if you stop the test or close the window during it.</source>
        <translation>结束后舵机卸力。中途停止测试或关闭窗口也是如此。</translation>
    </message>
    <message>
        <source>Afterwards they hold their position with torque on. The same applies if you stop the test or close the window during it.</source>
        <translation>结束后舵机保持位置，扭矩开启。中途停止测试或关闭窗口也是如此。</translation>
    </message>
    <message>
        <source>Motion could not be stopped: %1.</source>
        <translation>未能停止运动：%1。</translation>
    </message>
    <message>
        <source>No answer from %1 for %2</source>
        <translation>%1 已 %2 无应答</translation>
    </message>
    <message>
        <source>The test has ended; stopping the servos</source>
        <translation>测试已结束，正在停止舵机</translation>
    </message>
    <message>
        <source>range %1 … %2</source>
        <translation>行程 %1 … %2</translation>
    </message>
    <message>
        <source>Such a servo may still hold or move to its last goal. Press the emergency stop or cut the supply.</source>
        <translation>这些舵机可能仍在保持位置，或继续走向最后的目标。请按急停，或切断供电。</translation>
    </message>
    <message>
        <source>targets of the list</source>
        <translation>列表中的目标</translation>
    </message>
    <message>
        <source>Those that go back to another mode have their torque off afterwards.</source>
        <translation>切回其他模式的舵机，测试后扭矩为关闭状态。</translation>
    </message>
    <message>
        <source>Keep hands and objects out of their way. Esc takes torque off all servos at once.</source>
        <translation>双手和物体请离开舵机的运动范围。按 Esc 立即关闭所有舵机的扭矩。</translation>
    </message>
    <message>
        <source>The test was not started.</source>
        <translation>测试没有开始。</translation>
    </message>
    <message>
        <source>A servo it was meant for has left the list or was exchanged.</source>
        <translation>要测试的舵机已不在列表中，或已被更换。</translation>
    </message>
    <message>
        <source>Choose the servo and start again.</source>
        <translation>请选择舵机后重新开始。</translation>
    </message>
    <message>
        <source>%1 (own value %2)</source>
        <translation>%1（原值 %2）</translation>
    </message>
    <message>
        <source>Settings of the test still in the servo: %1.</source>
        <translation>测试的设置仍在舵机中：%1。</translation>
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
        <source>running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>No test has run yet. Choose a test at the left, look at start and end, then press Run: the servo will move.</source>
        <translation>尚未运行测试。在左侧选择测试，确认起启与结束，然后按“运行”：舵机将会运动。</translation>
    </message>
    <message>
        <source>The servo that is shown</source>
        <translation>当前显示的舵机</translation>
    </message>
    <message>
        <source>Servo shown</source>
        <translation>显示的舵机</translation>
    </message>
    <message>
        <source>Figures and their grades</source>
        <translation>各项数值与判定</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>行程</translation>
    </message>
    <message>
        <source>All figures</source>
        <translation>全部数值</translation>
    </message>
    <message>
        <source>Show the figures without a limit, too</source>
        <translation>也显示没有限值的数值</translation>
    </message>
    <message>
        <source>Error at the target</source>
        <translation>到位误差</translation>
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
        <source>Look at kept tests, compare two, choose a reference</source>
        <translation>查看已保存的测试，比较两次测试，选定参考舵机</translation>
    </message>
    <message>
        <source>Silences of the line that were waited out: %1.</source>
        <translation>已等待恢复的通信中断：%1 次。</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>Each row tells more when the mouse rests on it</source>
        <translation>鼠标停在某一行上可看到更多内容</translation>
    </message>
    <message>
        <source>All legs as a table, and all readings in a file beside it</source>
        <translation>全部行程数据的表格，旁边另有全部采样数据的文件</translation>
    </message>
    <message>
        <source>Save the report as %1, and all readings in a file beside it</source>
        <translation>将报告保存为 %1，旁边另有全部采样数据的文件</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>无应答</translation>
    </message>
</context>
<context>
    <name>ui::SweepServos</name>
    <message>
        <source>Ticked: takes part in the test</source>
        <translation>勾选：参加测试</translation>
    </message>
    <message>
        <source>A range of its own; empty: start and end above</source>
        <translation>单独的范围；留空：用上面的起启与结束</translation>
    </message>
    <message>
        <source>Limits: %1</source>
        <translation>限值：%1</translation>
    </message>
    <message>
        <source>Limits: built in</source>
        <translation>限值：内置</translation>
    </message>
    <message>
        <source>Servos</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>Servos to be tested</source>
        <translation>要测试的舵机</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>舵机</translation>
    </message>
    <message>
        <source>own start</source>
        <translation>单独起启</translation>
    </message>
    <message>
        <source>own end</source>
        <translation>单独结束</translation>
    </message>
    <message>
        <source>Limits…</source>
        <translation>限值…</translation>
    </message>
    <message>
        <source>What the servo of the marked row is judged by: look, edit, load, save</source>
        <translation>所选行的舵机按什么限值判定：查看、编辑、载入、保存</translation>
    </message>
    <message>
        <source>Tick who takes part; start and end of their own, where they need them</source>
        <translation>勾选参加测试的舵机；需要时填写单独的起启与结束</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
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
</context>
<context>
    <name>ui::SweepVerdictModel</name>
    <message>
        <source>no limit</source>
        <translation>无限值</translation>
    </message>
</context>
<context>
    <name>ui::TemplateDialog</name>
    <message>
        <source>Save 1 row…</source>
        <translation>保存 1 行…</translation>
    </message>
    <message>
        <source>Save %1 rows…</source>
        <translation>保存 %1 行…</translation>
    </message>
    <message>
        <source>Make a template</source>
        <translation>制作模板</translation>
    </message>
    <message>
        <source>Tick what other servos are to be given. ID and rate are never part of a template. Ticked at first is what differs from the factory default.</source>
        <translation>勾选要写入其他舵机的内容。模板绝不包含 ID 和波特率。与出厂默认值不同的行已预先勾选。</translation>
    </message>
    <message>
        <source>Rows of the template</source>
        <translation>模板的行</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>寄存器</translation>
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
        <source>Save the ticked rows as a file</source>
        <translation>把勾选的行保存为文件</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Save nothing</source>
        <translation>不保存</translation>
    </message>
</context>
<context>
    <name>ui::TorqueHint</name>
    <message>
        <source>Before the first torque of this session</source>
        <translation>本次首次打开扭矩之前</translation>
    </message>
    <message>
        <source>• No bracket or horn that could catch or jam
• Fingers and cables away from the shaft
• Polarity and voltage of the supply checked
• Thick leads above 12 V</source>
        <translation>• 没有安装会卡住的支架或舵盘
• 手指和线缆远离输出轴
• 已检查电源极性和电压
• 高于 12 V 时使用粗导线</translation>
    </message>
    <message>
        <source>Do not show this again</source>
        <translation>不再显示</translation>
    </message>
    <message>
        <source>Also not in later sessions</source>
        <translation>以后启动也不显示</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Leave the servo as it is</source>
        <translation>保持舵机现状</translation>
    </message>
    <message>
        <source>Checked, go on</source>
        <translation>已检查，继续</translation>
    </message>
    <message>
        <source>Do what was asked for; the hint stays away until the program is started again</source>
        <translation>执行所请求的操作；本次运行不再提示</translation>
    </message>
</context>
<context>
    <name>ui::TrendChart</name>
    <message>
        <source>Trend chart</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>Drag: zoom into a box. Ctrl+drag or middle button: move. Wheel: zoom time; with Shift values. Double click or Backspace: back. Arrows, +, -, Y, Home, End, Space, F, C, brackets and digits do the same from the keyboard.</source>
        <translation>拖动：框选放大。Ctrl+拖动或中键：平移。滚轮：缩放时间；按住 Shift：缩放数值。双击或退格键：返回上一视图。方向键、+、-、Y、Home、End、空格、F、C、方括号和数字键可用键盘完成同样操作。</translation>
    </message>
    <message>
        <source>Whole recording</source>
        <translation>全部记录</translation>
    </message>
    <message>
        <source>Everything there is. Drag the frame to look elsewhere, its edges to see more or less.</source>
        <translation>全部数据。拖动方框查看别处，拖动其边缘显示更多或更少。</translation>
    </message>
    <message>
        <source>No channels chosen</source>
        <translation>未选择通道</translation>
    </message>
    <message>
        <source>All channels are hidden</source>
        <translation>所有通道均已隐藏</translation>
    </message>
    <message>
        <source>No file name was given.</source>
        <translation>未指定文件名。</translation>
    </message>
    <message>
        <source>%1 could not be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
</context>
<context>
    <name>ui::TrendPanel</name>
    <message>
        <source>Waiting — cancel</source>
        <translation>等待中 — 取消</translation>
    </message>
    <message>
        <source>Triggered …</source>
        <translation>已触发…</translation>
    </message>
    <message>
        <source>%1 · %2 rows</source>
        <comment>time, number</comment>
        <translation>%1 · %2 行</translation>
    </message>
    <message>
        <source>The recording has ended: %1</source>
        <translation>记录已结束：%1</translation>
    </message>
    <message>
        <source>%1 rows are safe in %2. %3</source>
        <translation>%1 行已安全保存在 %2。%3</translation>
    </message>
    <message>
        <source>%1 rows found no room and are missing: the disk was too slow.</source>
        <translation>%1 行未能写入而丢失：磁盘太慢。</translation>
    </message>
    <message>
        <source>%1 rows recorded in %2</source>
        <translation>已记录 %1 行：%2</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>打开记录</translation>
    </message>
    <message>
        <source>Recordings (*.csv *.jsonl)</source>
        <translation>记录 (*.csv *.jsonl)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Recording %1: %2 rows</source>
        <translation>记录 %1：%2 行</translation>
    </message>
    <message>
        <source>Its last line is cut off: what was measured before is shown.</source>
        <translation>最后一行不完整：显示此前测量的数据。</translation>
    </message>
    <message>
        <source>Lines that could not be understood: %1</source>
        <translation>无法理解的行：%1</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>图片 (*.png)</translation>
    </message>
    <message>
        <source>Drawing (*.svg)</source>
        <translation>矢量图 (*.svg)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>The picture could not be saved: %1</source>
        <translation>图片无法保存：%1</translation>
    </message>
    <message>
        <source>Check the folder and the space on the disk.</source>
        <translation>请检查文件夹和磁盘空间。</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
    <message>
        <source>Keep this view</source>
        <translation>保留此视图</translation>
    </message>
    <message>
        <source>Its name:</source>
        <translation>名称：</translation>
    </message>
</context>
<context>
    <name>ui::TrendToolbar</name>
    <message>
        <source>Trigger…</source>
        <translation>触发…</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>停止记录</translation>
    </message>
    <message>
        <source>Record…</source>
        <translation>记录…</translation>
    </message>
    <message>
        <source>Save the &amp;picture…</source>
        <translation>保存图片(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Open a recording…</source>
        <translation>打开记录(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Clear the history</source>
        <translation>清除历史(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Keep this view as…</source>
        <translation>保留此视图为(&amp;K)…</translation>
    </message>
    <message>
        <source>&amp;Remove a view</source>
        <translation>删除视图(&amp;R)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Let the picture stand still; measuring goes on (Space)</source>
        <translation>让画面静止；测量不中断（空格键）</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Show everything that was measured</source>
        <translation>显示全部测量数据</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>The view before the last zoom (double click)</source>
        <translation>上次缩放之前的视图（双击）</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>游标</translation>
    </message>
    <message>
        <source>Measure between two cursors</source>
        <translation>在两个游标之间测量</translation>
    </message>
    <message>
        <source>Curves…</source>
        <translation>曲线…</translation>
    </message>
    <message>
        <source>Choose which registers of which servos are shown</source>
        <translation>选择显示哪些舵机的哪些寄存器</translation>
    </message>
    <message>
        <source>Let the picture stand when something happens</source>
        <translation>当某事发生时让画面静止</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>Pictures, recordings, kept views</source>
        <translation>图片、记录、保留的视图</translation>
    </message>
    <message>
        <source>Back to the servos</source>
        <translation>回到舵机</translation>
    </message>
    <message>
        <source>Leave the recording and show what is measured now</source>
        <translation>离开记录，显示当前测量</translation>
    </message>
    <message>
        <source>Write what is measured to a file</source>
        <translation>把测量值写入文件</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>正在记录</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>显示时长</translation>
    </message>
    <message>
        <source>How much time the chart shows</source>
        <translation>曲线图显示的时间长度</translation>
    </message>
    <message>
        <source>Readings per second</source>
        <translation>每秒读取次数</translation>
    </message>
    <message>
        <source>How often the servos are read</source>
        <translation>读取舵机的频率</translation>
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
        <source>fastest</source>
        <translation>最快</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
</context>
<context>
    <name>ui::TriggerDialog</name>
    <message>
        <source>The chart stands still when it has happened</source>
        <translation>发生后曲线静止</translation>
    </message>
    <message>
        <source>Nothing is read that could tell</source>
        <translation>没有读取可判断的数据</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>触发</translation>
    </message>
    <message>
        <source>The value rises through a level</source>
        <translation>数值上升穿过电平</translation>
    </message>
    <message>
        <source>The value falls through a level</source>
        <translation>数值下降穿过电平</translation>
    </message>
    <message>
        <source>The value is above a level</source>
        <translation>数值高于电平</translation>
    </message>
    <message>
        <source>The value is below a level</source>
        <translation>数值低于电平</translation>
    </message>
    <message>
        <source>The servo begins to move</source>
        <translation>舵机开始移动</translation>
    </message>
    <message>
        <source>The servo has stopped</source>
        <translation>舵机停止移动</translation>
    </message>
    <message>
        <source>A fault appears</source>
        <translation>出现故障</translation>
    </message>
    <message>
        <source>Something is written</source>
        <translation>有写入操作</translation>
    </message>
    <message>
        <source>A servo stops answering</source>
        <translation>舵机停止应答</translation>
    </message>
    <message>
        <source>Wait until</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>What the chart is to wait for</source>
        <translation>曲线图要等待的事件</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>The curve that is watched</source>
        <translation>被监视的曲线</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>电平</translation>
    </message>
    <message>
        <source>In the unit of the curve</source>
        <translation>以曲线的单位</translation>
    </message>
    <message>
        <source>Hysteresis</source>
        <translation>迟滞</translation>
    </message>
    <message>
        <source>The value must first be so far on the other side: noise at the level counts once</source>
        <translation>数值必须先到另一侧这么远：电平附近的噪声只算一次</translation>
    </message>
    <message>
        <source>Seconds before</source>
        <translation>之前秒数</translation>
    </message>
    <message>
        <source>So much is shown before the moment</source>
        <translation>显示触发前的时间</translation>
    </message>
    <message>
        <source>Seconds after</source>
        <translation>之后秒数</translation>
    </message>
    <message>
        <source>And so much after it; then the chart stands still</source>
        <translation>以及触发后的时间，然后曲线静止</translation>
    </message>
    <message>
        <source>Wait for it</source>
        <translation>开始等待</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Close without a trigger</source>
        <translation>不触发并关闭</translation>
    </message>
</context>
<context>
    <name>ui::Welcome</name>
    <message>
        <source>No servos connected yet</source>
        <translation>尚未连接舵机</translation>
    </message>
    <message>
        <source>Plug the adapter in, switch the servos&apos; supply on, choose the port above. Connecting and searching write nothing, and nothing moves.</source>
        <translation>插入适配器，打开舵机电源，在上方选择端口。连接和搜索不会写入任何内容，舵机也不会转动。</translation>
    </message>
    <message>
        <source>Connect the chosen port</source>
        <translation>连接所选端口</translation>
    </message>
    <message>
        <source>Open the port chosen above and search it</source>
        <translation>打开上方所选端口并搜索</translation>
    </message>
    <message>
        <source>No hardware at hand? The simulated bus has servos of several families, with a fault or two to find.</source>
        <translation>手边没有硬件？模拟总线上有多个系列的舵机，还带有一两处故障。</translation>
    </message>
    <message>
        <source>Try it on a simulated bus</source>
        <translation>用模拟总线试用</translation>
    </message>
    <message>
        <source>Simulated servos; nothing needs to be connected</source>
        <translation>模拟舵机，无需连接任何硬件</translation>
    </message>
</context>
</TS>
