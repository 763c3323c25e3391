"""The Chinese of every help text, by its English: what is not here is a failing test."""

from __future__ import annotations

LABELS = {  # what stands in place of a value, in the order in which it is looked for
    "COMMAND [ARGS]...": "命令 [参数]...",
    "OPTIONS": "选项",
    "ID_OR_FILE": "题号或文件",
    "ID_OR_PATH": "题号或文件",
    "SYMBOL=VALUE": "符号=值",
    "HEADER=MEANING": "列名=含义",
    "FILE": "文件",
    "PATH": "路径",
    "FOLDER": "文件夹",
    "NAME": "名称",
    "KEYS": "量",
    "KEY": "量",
    "LETTERS": "字母",
    "ID": "题号",
    "TEXT": "文本",
    "what": "内容",
    "folder": "文件夹",
    "<int range>": "整数",
    "<float range>": "数",
    "<int>": "整数",
    "<float>": "数",
    "<str>": "",
    "<list[str]>": "",
    "<path>": "",
    "<place>": "",
    "<Path>": "文件夹",
    "ASSIGNMENT": "作业文件",
    "ANSWERS": "答案",
    "ADDRESS": "地址",
    "I/N": "I/N",
    "<list[Path]>": "",
}

HELP = {
    # commands
    "Velocity, acceleration and force polygons, drawn to scale, from a problem file to a printed report.": (
        "按比例尺作速度多边形、加速度多边形和力多边形：由题目文件到可打印的报告。"
    ),
    "Print the answers: as drawn, exact, and how far off.": "列出各所求量：图上量得的值、精确值和偏差。",
    "Print the analytic answers, without a drawing.": "只列出解析解，不作图。",
    "Write reports as PDF.\n\nWith -o FILE.pdf everything goes into this one file; with -o FOLDER, every problem "
    "or assignment gets a file there. Without -o the files are written here.": (
        "写出 PDF 报告。\n\n用 -o 文件.pdf 时全部写入该文件；用 -o 文件夹 时每道题或每份作业各写一个文件；不写 -o "
        "时写在当前文件夹。"
    ),
    "Write the report of a design project: linkage, motion, forces, cam, gears, and whether the demands are met.": (
        "写出课程设计说明书：连杆机构、运动、受力、凸轮、轮系，以及各项要求是否满足。"
    ),
    "Search a linkage where no construction gives one: for a path, for a dwell, for the best transmission angle.\n\n"
    "-o FOUND.yaml writes it as a problem, to be drawn and analysed; -o FOUND.pdf its report.": (
        "在没有作图法的场合搜索机构：再现轨迹、实现停歇、传动角最大。\n\n"
        "-o 结果.yaml 写成题目，可作图和分析；-o 结果.pdf 写出报告。"
    ),
    "A search: search-dwell of the library, or a file.": "搜索：题库中的 search-dwell 等，或文件。",
    "Seed of the candidates: another has others.": "候选机构的随机种子：换一个就换一批候选。",
    "How many are tried, instead of the file's.": "候选数，代替文件中所写的。",
    "A project: design-shaper of the library, or a file.": "课程设计：题库中的 design-shaper 等，或文件。",
    "Take a mechanism through its whole cycle: print what is to be said of it, write tables, draw curves.": (
        "分析机构的整个运动循环：列出运动特性，写数据表，绘曲线。"
    ),
    "Draw a figure or the sheet as SVG, PNG, PDF or DXF.\n\n1 mm drawn is 1 mm on paper. A second page of a sheet "
    "goes to x-2.svg (a PDF has them all). A DXF has layers by what a line is for.": (
        "将一个图形或整张图纸绘成 SVG、PNG、PDF 或 DXF。\n\n图上 1 mm 即纸上 1 mm。图纸的第二页写入 x-2.svg（PDF "
        "含所有页）。DXF 按线的用途分图层。"
    ),
    "Write a GeoGebra file: turn the crank with a slider, and diagram, velocity and acceleration polygon "
    "follow.\n\nPoints are made of earlier points, as on the sheet; poles can be dragged. Drawn exactly; loads are "
    "left away. Of a cam: its profile, splines as .dxf or points as .csv.": (
        "写出 GeoGebra 文件：用滑动条转动曲柄，机构图、速度多边形和加速度多边形随之变动。\n\n各点都由先前的点作出，"
        "与图纸上相同；极点可拖动。按精确作图，不取整；不含载荷。"
        "凸轮题写出廓线：.dxf 为样条，.csv 为点。"
    ),
    "List the library, its problems, design projects, searches and assignments, or the methods.": (
        "列出题库中的题目、课程设计、搜索和作业，或已有的图解法。"
    ),
    "Write a step player: one HTML file for class, phone or desktop, in both languages.\n\nIt shows the "
    "construction line by line with the sentence of each step beside it, and the finished figures for every place "
    "of the crank.": (
        "写出分步演示：一个 HTML 文件，供课堂、手机或电脑使用，中英文兼备。\n\n逐线演示作图过程，旁附各步的说明，"
        "并可看曲柄在各位置时的全部图形。"
    ),
    "Write a problem file to start from: a commented one, or a copy of one of the library.": (
        "写出一个可供修改的题目文件：带注释的样板，或题库中某题的副本。"
    ),
    "Print the JSON Schema of problem files, assignments, design projects and searches.": (
        "输出题目文件、作业文件、课程设计文件和搜索文件的 JSON Schema。"
    ),
    "Render chapters 2 to 5 as assignments and one course report, in both languages, and one step player.": (
        "生成第 2 至 5 章的作业解答、一份课程报告（均有中英文）和一个分步演示。"
    ),
    # arguments
    "Problems or assignments: ids such as 3-9, or files.": "题目或作业：3-9 之类的题号，或文件。",
    "A problem or an assignment: an id such as A-27, or a file.": "题目或作业：A-27 之类的题号，或文件。",
    "A problem or an assignment: an id such as 3-9, or a file.": "题目或作业：3-9 之类的题号，或文件。",
    "What to list.": "列出什么。",
    "The file to write; .yaml is added where it has no ending.": "要写的文件；没有扩展名时加 .yaml。",
    # options
    "Chinese or English.": "中文或英文。",
    "Chinese or English; that of the class where nothing is said.": "中文或英文；不写时与作业相同。",
    "How what is refused is told: as text, or as JSON, a line each, for programs.": (
        "错误信息的形式：文本，或供程序读取的 JSON（每行一条）。"
    ),
    "How accurately is drawn: exact; drafting (0.1 mm); pencil (0.5 mm, with scatter).": (
        "作图精度：exact 精确；drafting 绘图仪器（0.1 mm）；pencil 铅笔手绘（0.5 mm，有随机误差）。"
    ),
    "Seed of the hand's scatter.": "作图随机误差的种子。",
    "A printed table over the cycle, CSV or XLSX.": "一个运动循环的数据表，CSV 或 XLSX。",
    "What columns of the table hold: phi_5=rad, w3=omega_4, V=v_E[mm/s], remarks=- (left out).": (
        "各列的含义：phi_5=rad、w3=omega_4、V=v_E[mm/s]、备注=-（略去）。"
    ),
    "Write JSON to this file, or to stdout with -.": "将结果以 JSON 写入此文件；- 为标准输出。",
    "The solution; the question with blank frames to draw in; or the course report over the whole cycle.": (
        "解答；留有作图空框的题目；或整个运动循环的课程报告。"
    ),
    "File or folder to write, or - for standard output; missing folders are made.": (
        "要写的文件或文件夹，- 为标准输出；没有的文件夹会自动建立。"
    ),
    "Read files that the problem file names outside its folder and the library, too.": (
        "也读取题目文件所引用的、其文件夹和题库以外的文件。"
    ),
    "Number of positions, both ends included.": "位置数，含两端。",
    "Instead of -n: positions at the whole multiples of this step of the drive, in degrees (mm of a sliding input).": (
        "代替 -n：原动件位置取此步长的整数倍，单位为度（移动原动件为 mm）。"
    ),
    "Write a table: .csv or .xlsx, or - for CSV to standard output; missing folders are made.": (
        "写数据表：.csv 或 .xlsx，- 为将 CSV 写到标准输出；没有的文件夹会自动建立。"
    ),
    "Draw curves: .svg, .pdf or .png.": "绘曲线：.svg、.pdf 或 .png。",
    "Quantities, such as omega_5,alpha_5,a_F,M_1; phi_5, s_45, gamma_23, v_F.x too.": (
        "量，如 omega_5,alpha_5,a_F,M_1；也可用 phi_5、s_45、gamma_23、v_F.x。"
    ),
    "With --plot: the paths of these points, F or E,F.": "与 --plot 同用：绘这些点的轨迹，如 F 或 E,F。",
    "With --plot: the hodograph of a vector, a_F.": "与 --plot 同用：绘矢量的矢端图，如 a_F。",
    "mechanism, velocity, acceleration, body, force; one of several by its name: force:3; sheet is the whole A4 "
    "page.": "mechanism、velocity、acceleration、body、force；同类有几个时用名称，如 force:3；sheet 为整张 A4 图纸。",
    "The paper as it stands after step N.": "只画到第 N 步为止。",
    "List the steps of the construction too, and what the hand did in each.": (
        "同时列出作图各步，以及每步中的作图动作。"
    ),
    "Of a synthesis: go on with the linkage that was found, analyse.": "综合题：对求得的机构继续作运动分析（analyse）"
    "。",
    "Resolution of a PNG.": "PNG 的分辨率（dpi）。",
    "Places of the crank over its turn; 0 leaves its slider away.": "曲柄一周的位置数；0 则不显示转动滑条。",
    "Start from a problem of the library: a screw jack from 5-5, forces from 4-3a.": (
        "以题库中的题目为样板：5-5 为螺旋千斤顶，4-3a 为力分析。"
    ),
    "The folder to write to.": "写入的文件夹。",
    "Print the version and leave.": "输出版本号。",
    "Show this message and exit.": "显示本说明。",
    "Install completion for the current shell.": "为当前 shell 安装自动补全。",
    "Show completion for the current shell, to copy it or customize the installation.": (
        "显示当前 shell 的自动补全脚本，供复制或自行安装。"
    ),
    "Check printed answers, or a printed table, against exact values.\n\nEach gets a verdict and, if "
    "wrong, the slip that explains it; where several are wrong, all crank angles and assemblies are tried, "
    "to see whether the numbers are possible at all. With --table, the columns of a table over the cycle "
    "are compared. Answers of one's own may stand behind the problem: check 3-12 v_D=0.49 ω5=4.72 \"α3=12 "
    'rad/s² cw". Each is right, close, or wrong with the reason, where one slip alone explains it.\n\n'
    "Exit code: 0 all agrees, 1 something printed is wrong, 2 it cannot be checked.": (
        "将书中答案或数据表与精确值核对。\n\n每个答案给出结论，错误的给出可解释它的差错；有多个错误时，"
        "试遍各曲柄转角和装配方式，看这些数是否可能出现。用 --table 时逐列比较一个运动循环的数据表。"
        '自己的答案可写在题号之后：check 3-12 v_D=0.49 ω5=4.72 "α3=12 rad/s² 顺"，逐个判为正确、接近或错误，'
        "只有一种差错能解释时说明缘由。\n\n退出码：0 全部相符，1 有错误，2 无法核对。"
    ),
    "Try what `vary` and `gate` of a problem give: how many draws pass, what fails, what is demoted, and "
    "some variants.\n\nWith --propose, ranges are found for problems that have none: numbers that the text does not "
    "tell, in round steps, as many of them as a class needs. -o HW.yaml writes the assignment for 'vecpoly class'.": (
        "试一试题目的 vary 和 gate：合格的比例、不合格的原因、降为连带评分的量，并列出几组数据。\n\n"
        "用 --propose 为没有 vary 的题目给出取值范围：题目正文未写出的数据，按整步长，够全班使用为止。"
        "-o HW.yaml 写出供 vecpoly class 使用的作业。"
    ),
    "Find ranges for problems that have none: an assignment to start from.": (
        "为没有 vary 的题目给出取值范围，作为作业的起点。"
    ),
    "How many students the proposed ranges shall tell apart.": ("给出的范围应能区分的学生数。"),
    "The assignment to write, YAML.": ("要写出的作业（YAML）。"),
    "Give everybody on a roster own numbers: question and solution PDFs, register, key, answers form, "
    "Moodle questions.\n\nKilled at any moment, it goes on where it was when it is started again.": (
        "给名单上的每个人一组数据：题目与解答 PDF、登记表、答案键、答案录入表、Moodle 题目。\n\n随时中断，"
        "再次运行即从中断处继续。"
    ),
    "The folder that 'vecpoly class' wrote.": ("vecpoly class 写出的文件夹。"),
    "Answers: the form, CSV, YAML or JSON.": ("答案：生成的答案表、CSV、YAML 或 JSON。"),
    "Drawings (DXF, SVG, PDF, GGB) named NUMBER_PROBLEM, graded vector by vector.": (
        "作图文件（DXF、SVG、PDF、GGB），命名为 学号_题号，逐个矢量批改。"
    ),
    "The format of the paper, in place of the problem's own (A4).": ("图纸和报告的幅面，代替题中所写（缺省 A4）。"),
    "In black alone: for examinations, and for printers without colours.": ("只用黑色：用于考试，或无彩色的打印机。"),
    "With a box for one's own answers: right, close, or wrong and why.": (
        "带一个核对自己答案的框：正确、接近，或错误及其原因。"
    ),
    "Rules and points, as YAML.": ("评分规则和分值（YAML）。"),
    "Tell what is marked otherwise than there.": ("列出与该文件夹中批改结果的不同。"),
    "Write a feedback sheet for everybody.": ("为每人写一份反馈。"),
    "The assignment: a YAML file that lists problems.": ("作业：列有题目的 YAML 文件。"),
    "Numbers, names and classes: XLSX or CSV.": ("学号、姓名、班级：XLSX 或 CSV。"),
    "Processes; as many as there are processors where 0 is said.": ("进程数；0 则与处理器数相同。"),
    "Write only every Nth sheet, from the Ith (0/4 ... 3/4), and a manifest; --gather completes the class.": (
        "只写每 N 份中的一份，从第 I 份起（0/4 …… 3/4），并写清单；用 --gather 汇总成整班。"
    ),
    "Complete the class from this folder of shards, or from several: all there, none twice, bytes equal.": (
        "由这个（或几个）文件夹中的分片汇总成整班：各片齐全、无人重复、字节相同。"
    ),
    "Let a Dask cluster do the work: the address of its scheduler.": ("由 Dask 集群来做：写调度器的地址。"),
    "Also a table with the columns of another platform, as this YAML file says.": (
        "另按此 YAML 文件写出其他平台所需的表。"
    ),
    "Problems or assignments with `vary`.": ("含 vary 的题目或作业。"),
    "How many variants to draw.": ("列出几组数据。"),
    "Another text gives other numbers.": ("换一个文本就换一批数据。"),
    "The problems, and answers such as v_D=0.49.": ("题目，以及 v_D=0.49 之类的答案。"),
    "Mark the answers of a class: grades, a feedback sheet for everybody, item analysis, a queue for a "
    "person.\n\nRight within what a drawing may be off by, or right by one's own earlier values; each "
    "mistake costs once, and is named where one slip alone explains it. Marked again, the same answers "
    "have the same marks; --diff tells what changed.\n\nExit code: 0 all was read (what waits for a person is "
    "counted, and stands in queue.csv), 2 a file, a row or a drawing could not be read (the rest is marked all "
    "the same).": (
        "批改全班的答案：成绩、每人一份反馈、逐题分析、待人工批改的清单。\n\n在作图允许误差之内为正确，"
        "按自己前面的结果算对的也为正确；每个错误只扣一次，只有一种差错能解释时说明原因。"
        "同样的答案再批一次，成绩相同；--diff 列出与前次的不同。\n\n退出码：0 全部读入"
        "（待人工批改者已计数，见 queue.csv），2 有文件、行或图读不出（其余照常批改）。"
    ),
}
