import type { Dictionary } from './i18n.ts';

/** Texts that most visits have no use for, in Chinese: they come when they are asked for. */
export const seldomInChinese: Pick<
  Dictionary,
  | 'keys'
  | 'focusByClick'
  | 'fileUnreadable'
  | 'phases'
  | 'dropHere'
  | 'compilingFor'
  | 'noticeParameters'
  | 'noticeUnknownParameters'
  | 'noticeLost'
  | 'noticeFailed'
  | 'noticeCpuChosen'
  | 'noticeCpuComputes'
  | 'noticeNothingInFocus'
  | 'problemsIntro'
  | 'classicHasNoMeshes'
  | 'compareClassic'
  | 'comparePicture'
  | 'stillShowsPicture'
  | 'stillHasNoLens'
  | 'stillDoesNotPlay'
  | 'gestures'
  | 'noticeCpuShowsClassic'
  | 'noticeMadeForPaths'
  | 'noticeCpuAlone'
  | 'tooManyFiles'
  | 'noticeSwitchFailed'
  | 'noticeStartFailed'
  | 'noticeSceneFailed'
> = {
  focusByClick: '点按画面中的物体，或按 O 键，即可对焦。',
  fileUnreadable: (file, reason) => `读取 ${file} 失败：${reason}`,
  phases: {
    reading: '读取文件',
    geometry: '生成三角形',
    images: '解码图片',
    trees: '构建加速结构',
  },
  dropHere: '松开即可打开模型（连同用到的文件）、文件夹或 zip；.hdr、.exr 用作环境光',
  compilingFor: (backend) => `同类模型只需在 ${backend} 上准备一次，完成之前先显示草图。`,
  noticeParameters: (problems) => `网址中有参数取值无效，已忽略：${problems}`,
  noticeUnknownParameters: (names) => `网址中有无法识别或重复的参数，已忽略：${names}`,
  noticeLost: '图形设备连接中断，正在恢复画面……',
  noticeFailed: (reason) => `图形设备已不可用：${reason}`,
  noticeCpuChosen: '这是由 CPU 以双精度计算的静态画面。',
  noticeCpuComputes: 'CPU 正在计算画面，完成之前继续显示原来的画面。',
  noticeNothingInFocus: '这里没有可以对焦的物体。',
  problemsIntro: '发现以下问题，原来的场景不受影响。',
  classicHasNoMeshes: '经典光线追踪无法绘制三角形网格，因此模型始终使用路径追踪。',
  compareClassic: '对比的是经典光线追踪的参数，请先切换到该渲染方法。',
  comparePicture: '对比的是渲染画面，请先把“显示内容”改回“画面”。',
  stillShowsPicture: 'CPU 静帧只能显示画面本身。',
  stillHasNoLens: 'CPU 静帧不支持镜头景深。',
  stillDoesNotPlay: 'CPU 静帧不能播放，可以拖动时间选择画面。',
  noticeCpuShowsClassic:
    '路径追踪需要 WebGPU 或 WebGL2。这幅静态画面改用经典光线追踪绘制：没有间接光照，材质也只有漫反射和镜面两种效果。',
  noticeMadeForPaths: '这个场景为路径追踪而设计：经典光线追踪不支持其中的玻璃、金属和多数光源，画面会偏暗。',
  noticeCpuAlone: '当前浏览器既不支持 WebGPU 也不支持 WebGL2，这里显示的是由 CPU 计算的静态画面。',
  tooManyFiles: '该文件夹中的文件超过 10,000 个，请只选择模型所在的文件夹。',
  noticeSwitchFailed: (backend, reason) => `${backend} 启动失败，继续使用原来的后端：${reason}`,
  noticeStartFailed: (backend, reason) => `${backend} 启动失败，已改用其他后端：${reason}`,
  noticeSceneFailed: (reason) => `场景无法显示：${reason}`,

  keys: {
    play: '播放 / 暂停',
    step: '前进 1/60 秒',
    scene: '选择场景',
    reflections: '减少 / 增加反射次数',
    compare: '切换对比方式',
    orbit: '环绕观察',
    pan: '平移视角',
    dolly: '推近 / 拉远',
    focus: '对焦到指针处；指针不在画面上时，对焦到画面中央',
    reset: '还原视角',
    frame: '显示全部',
    fullScreen: '全屏',
    panel: '展开 / 收起面板',
    help: '显示本列表',
  },
  gestures: {
    orbit: ['左键拖动、单指或手写笔', '环绕观察'],
    pan: ['右键拖动、Shift + 拖动或双指拖动', '平移视角'],
    dolly: ['滚轮或双指捏合', '推近 / 拉远'],
    focus: ['单击或轻点', '对该处对焦（光圈大于 0 时）'],
    drop: ['拖入文件、文件夹或 zip', '打开模型或场景'],
  },
};
