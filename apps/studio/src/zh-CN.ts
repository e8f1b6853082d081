import type { Dictionary } from './i18n.ts';
import { problemText, reportText, seldom } from './said-in-chinese.ts';

export const zhCN: Dictionary = {
  title: 'Mirrorball 光线追踪',
  pictureOf: (scene) => `“${scene}”场景的光线追踪画面，方向键可环绕观察。`,
  controls: '控制面板',
  foldPanel: '收起面板',
  unfoldPanel: '展开面板',
  close: '关闭',
  dismiss: '知道了',

  scene: '场景',
  sceneNames: {
    'cube-room': '立方体房间',
    'mirror-blocks': '镜面积木',
    'moving-shadows': '流动的阴影',
    materials: '材质陈列',
  },
  openFile: '打开文件…',
  openFolder: '打开文件夹…',
  openHint: '也可以直接拖到页面任意处：glTF、GLB、OBJ、PLY、STL 或 scene.json，连同用到的文件，或打包成 zip。',
  get dropHere() {
    return seldom().dropHere;
  },
  get tooManyFiles() {
    return seldom().tooManyFiles;
  },

  opening: (file) => `正在打开 ${file}`,
  get phases() {
    return seldom().phases;
  },
  cancel: '取消',
  compiling: '正在准备路径追踪',
  get compilingFor() {
    return seldom().compilingFor;
  },

  model: '模型',
  factFile: '文件',
  factTriangles: '三角形',
  factMaterials: '材质',
  factTextures: '贴图',
  factMemory: '占用内存',
  count: (n) => n.toLocaleString('zh-CN'),
  megabytes: (n) => `${n} MB`,
  camera: '相机',
  cameraFramed: '显示全部',
  clip: '动画片段',
  clipNone: '无',
  variant: '外观方案',
  variantOwn: '文件默认',
  frame: '显示全部',
  ground: '地面',
  report: (n) => `导入报告：${n} 条`,
  reportKinds: { unsupported: '不支持', changed: '有改动', unused: '未用到' },
  reportEntry: reportText,

  environment: '环境光',
  environmentKind: '光照来源',
  environmentOwn: '场景自带',
  environmentStudio: '摄影棚',
  environmentSky: '纯色天空',
  openEnvironment: '打开 .hdr 或 .exr…',
  strength: '强度',
  times: (n) => `${n} 倍`,
  turn: '旋转',
  degrees: (n) => `${n}°`,
  turnNeedsPicture: '纯色天空各个方向都一样，旋转没有效果',

  light: '光照',
  integrator: '渲染方法',
  integratorNames: { classic: '经典光线追踪', path: '路径追踪' },
  maxDepth: '路径段数',
  noLimit: '不限',
  get compareClassic() {
    return seldom().compareClassic;
  },
  get comparePicture() {
    return seldom().comparePicture;
  },
  get classicHasNoMeshes() {
    return seldom().classicHasNoMeshes;
  },
  reflections: '反射次数',
  lightSamples: '光源采样数',
  lightSamplesCustom: '自定义',
  lightSamplesNumber: '光源采样数：1 到 256',
  exposure: '曝光',
  stops: (n) => `${n} 档`,
  toneMapping: '色调映射',
  toneMappingNames: { none: '无', aces: 'ACES', agx: 'AgX', neutral: '中性' },

  compare: '对比',
  compareWhat: '并排对比',
  compareOff: '关',
  compareReflections: '反射次数',
  compareSamples: '光源采样',
  divider: (n) => `第 ${n} 条分隔线，共 2 条`,
  setByComparison: (values) => `并排对比时固定为 ${values}`,
  panelReflections: (n) => `反射 ${n} 次`,
  panelSamples: (n) => `光源采样 ${n} 点`,

  motion: '动画',
  play: '播放',
  pause: '暂停',
  step: '前进 1/60 秒',
  speed: '速度',
  time: '时间',
  get stillDoesNotPlay() {
    return seldom().stillDoesNotPlay;
  },
  seconds: (n) => `${n} 秒`,

  view: '视角',
  show: '显示内容',
  viewNames: {
    picture: '画面',
    albedo: '反照率',
    normal: '法线',
    'geometric-normal': '几何法线',
    depth: '深度',
    position: '位置',
    'primitive-id': '物体编号',
    'material-id': '材质编号',
  },
  onlyPath: '仅用于路径追踪',
  aperture: '光圈半径',
  focusDistance: '对焦距离',
  metres: (n) => `${n} 米`,
  focusNeedsAperture: '光圈为 0 时，画面处处清晰，无需对焦',
  get focusByClick() {
    return seldom().focusByClick;
  },
  get stillHasNoLens() {
    return seldom().stillHasNoLens;
  },
  noLensInPanorama: '全景相机没有镜头',
  get noticeNothingInFocus() {
    return seldom().noticeNothingInFocus;
  },
  get noticeCpuShowsClassic() {
    return seldom().noticeCpuShowsClassic;
  },
  get noticeMadeForPaths() {
    return seldom().noticeMadeForPaths;
  },
  get stillShowsPicture() {
    return seldom().stillShowsPicture;
  },
  resetView: '还原视角',
  fullScreen: '全屏',
  leaveFullScreen: '退出全屏',

  quality: '性能',
  resolution: '渲染分辨率',
  percent: (n) => `${n}%`,
  adaptive: '卡顿时自动降低分辨率',
  target: '目标帧率',
  fps: (n) => `${n} 帧/秒`,
  backend: '渲染后端',
  backendNames: { webgpu: 'WebGPU', webgl2: 'WebGL2', cpu: 'CPU' },
  cpuStill: 'CPU 静帧',

  page: '页面',
  language: '语言',
  theme: '外观',
  themeSystem: '跟随系统',
  themeLight: '浅色',
  themeDark: '深色',
  help: '快捷键与手势',

  status: '上一帧的渲染数据',
  unitFps: '帧/秒',
  unitMs: '毫秒',
  unitSample: '次采样',
  unitSamples: '次采样',
  unitMrays: '百万光线/秒',
  unitError: '误差',
  unitTime: '用时',

  problemsTitle: (file) => `无法打开 ${file}`,
  get problemsIntro() {
    return seldom().problemsIntro;
  },
  problem: problemText,
  wholeFile: '（整个文件）',
  copy: '复制',
  copied: '已复制',
  get fileUnreadable() {
    return seldom().fileUnreadable;
  },

  get noticeCpuAlone() {
    return seldom().noticeCpuAlone;
  },
  get noticeCpuChosen() {
    return seldom().noticeCpuChosen;
  },
  get noticeCpuComputes() {
    return seldom().noticeCpuComputes;
  },
  get noticeLost() {
    return seldom().noticeLost;
  },
  get noticeFailed() {
    return seldom().noticeFailed;
  },
  get noticeSwitchFailed() {
    return seldom().noticeSwitchFailed;
  },
  get noticeStartFailed() {
    return seldom().noticeStartFailed;
  },
  noticeNothing: (reason) => `无法在此设备上绘制画面：${reason}`,
  get noticeSceneFailed() {
    return seldom().noticeSceneFailed;
  },
  get noticeParameters() {
    return seldom().noticeParameters;
  },
  get noticeUnknownParameters() {
    return seldom().noticeUnknownParameters;
  },
  noticeError: (reason) => `出错了：${reason}`,

  keysTitle: '键盘',
  gesturesTitle: '鼠标、触摸与手写笔',
  get keys() {
    return seldom().keys;
  },
  get gestures() {
    return seldom().gestures;
  },
  keyNames: { space: '空格', arrows: '方向键', shiftArrows: 'Shift + 方向键' },
};
