import type { ExportEntry } from 'mirrorball/scene-export';

/** What other formats lack, in Chinese. Here stands each form of the English sentences; one of none of them stays as it is. */

type Form = readonly [pattern: RegExp, say: (...parts: string[]) => string];

/** Layers of materials. */
const LAYERS: Readonly<Record<string, string>> = {
  transmission: '透射',
  'diffuse transmission': '漫透射',
  clearcoat: '清漆',
  sheen: '绒面光泽',
  anisotropy: '各向异性',
  iridescence: '薄膜虹彩',
  dispersion: '色散',
};

const forms: readonly Form[] = [
  [/^Light of glTF comes from one direction/, () => 'glTF 的平行光没有角度大小，太阳不再有圆面。'],
  [/^glTF has no equirectangular camera/, () => 'glTF 没有全景相机。'],
  [/^Cameras of glTF have no lens/, () => 'glTF 的相机没有镜头，画面处处清晰。'],
  [/^Tracks of keyframes/, () => '关键帧动画（animation）停在静止状态。'],
  [/^glTF has no way to move (.*)\.$/, (target) => `glTF 无法让 ${target} 运动。`],
  [/^A clip that moves nothing/, () => '略去了没有带动任何内容的动画片段。'],
  [/^glTF leaves it to players/, () => '动画片段是否循环由播放器决定。'],
  [/^glTF has no mirror layer/, () => 'glTF 没有镜面层（reflectivity）。'],
  [/^glTF has no highlight/, () => 'glTF 没有经典光线追踪的高光（specular）。'],
  [/^glTF leaves to renderers what light is given back/, () => 'glTF 不记录能量补偿（energyCompensation）。'],
  [/^Masking is height-correlated there/, () => '其中的遮蔽函数与高度相关。'],
  [/^A measured metal has/, () => '实测金属只保留正对时的颜色，其余角度按 Schlick 公式计算。'],
  [/^A metal of one colour/, () => '各角度同色的金属，掠射时会变白。'],
  [/^Glass reflects by Schlick/, () => '玻璃的反射改按 Schlick 公式计算。'],
  [/^A lamp with an area/, () => '有面积的灯变为发光的黑色物体。'],
  [/^A light that is not to be seen is seen there(, and stands in the way of other light)?/, (blocks) => blocks ? '隐藏的光源会被看到，也会挡住其他光。' : '隐藏的光源会被看到。'], // biome-ignore format: one line each
  [/^A quad light shines to both sides/, () => '四边形光源变为两面发光。'],
  [/^Halos and ambient light/, () => '光晕和环境光只属于经典光线追踪，未保存。'],
  [/^glTF has no sky/, () => 'glTF 不含环境光，查看器会使用自己的。'],
  [/^glTF has no render settings/, () => 'glTF 不含渲染设置。'],
  [/^A material that no shape has/, () => '略去了没有物体使用的材质。'],
  [/^An infinite plane ends there/, () => '无限平面变为很大的有限平面。'],
  [/^A (sphere|box|quad) is triangles there/, (type) => `${{ sphere: '球体', box: '长方体', quad: '四边形' }[type]}变为三角形网格。`], // biome-ignore format: one line each
  [/^A sky of two colours/, () => '双色天空变为一幅图片。'],
  [/^What moves stands still as it is at (.*) s\.$/, (time) => `动画停在 ${time} 秒时的状态。`],
  [/^The classic integrator has other light/, () => 'Mitsuba 使用路径追踪，光照与经典光线追踪不同。'],
  [/^The file has linear light/, () => '文件中是线性光，曝光和色调映射由查看者决定。'],
  [/^Mitsuba has not all of this by itself: (.+) adds it/, (program) => `Mitsuba 缺少的部分由 ${program} 补充，请运行 python ${program} 渲染。`], // biome-ignore format: one line each
  [/^It shines to its front side only/, () => '只有正面发光。'],
  [/^Mitsuba's file has no (.*)\.$/, (layer) => `Mitsuba 文件不含${LAYERS[layer] ?? layer}。`],
  [/^Normal maps of meshes at several places/, () => '多处放置的网格，以及没有切线的网格，不含法线贴图。'],
  [/^Glass has no textures there/, () => '玻璃不含贴图。'],
  [/^A texture goes on beyond its edges/, () => '贴图在 v 方向的铺法与 u 方向相同。'],
  [/^What is cut out of a lamp/, () => '发光物体被镂空的部分仍会发光。'],
  [/^Light does not vary by colours of vertices/, () => '发光不随顶点颜色或第二组纹理坐标变化。'],
  [/^Light that single scattering loses/, () => '不含能量补偿（energyCompensation）。'],
  [/^Glass has no mirror layer/, () => '玻璃没有镜面层（reflectivity）。'],
  [/^A thin pane is smooth/, () => '薄板变为光滑表面。'],
  [/^Mitsuba warns of a rectangle/, () => '不是矩形的平行四边形，Mitsuba 会发出警告，光照可能不同。'],
  [/^The edge of a spot/, () => '聚光灯的边缘随角度线性变暗。'],
  [/^The sun is a point/, () => '太阳是无穷远处的一点：阴影边缘清晰，本身不可见。'],
];

export function savedInChinese({ message }: ExportEntry): string {
  for (const [pattern, say] of forms) {
    const match = pattern.exec(message);
    if (match) return say(...match.slice(1));
  }
  return message;
}
