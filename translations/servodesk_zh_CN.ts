<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
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
        <source>one by one, in one packet, or held and released together</source>
        <translation>普通写、同步写，或异步写后一起执行</translation>
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
        <source>nothing of it was written</source>
        <translation>什么都没写入</translation>
    </message>
    <message>
        <source>all of it was written</source>
        <translation>已全部写入</translation>
    </message>
    <message>
        <source>part of it was written</source>
        <translation>只写入了一部分</translation>
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
        <source>also changes begun on another port than this one</source>
        <translation>也包括在其他端口上开始的修改</translation>
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
        <source>The settings before are in %1</source>
        <translation>之前的参数保存在 %1</translation>
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
        <source>switch torque; on holds where the servo is</source>
        <translation>切换扭矩开关；打开后保持在当前位置</translation>
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
        <source>end the motion; torque stays as it is</source>
        <translation>停止运动；扭矩开关不变</translation>
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
        <source>Plug it in again. If a change was going on, look at the open changes (recover) before anything else.</source>
        <translation>重新插好。如果正在修改参数，请先查看未完成的修改（recover）。</translation>
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
        <source>Restore the connection and finish or undo the change (recover); switching the servo off closes the lock too.</source>
        <translation>恢复连接后完成或撤销修改（recover）；舵机断电也会上锁。</translation>
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
        <source>Torque is on now: the goal switched it on.</source>
        <translation>扭矩已打开：写目标时自动打开。</translation>
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
        <source>The EPROM lock could not be closed; it is noted in the journal. Use recover when the servo answers again.</source>
        <translation>EPROM 无法上锁；已记入日志。舵机恢复应答后请用 recover。</translation>
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
        <source>it restarted meanwhile, so the value is not kept</source>
        <translation>期间舵机重启，数值未能保存</translation>
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
</context>
</TS>
