import type { ReportEntry } from 'mirrorball';

/** What importers tell of a file, in Chinese. Here stands each form of their English sentences; one of none of them stays as it is. */

type Form = readonly [pattern: RegExp, say: (...parts: string[]) => string];

const forms: readonly Form[] = [
  [/^An animation moves nothing of the scene; it is left out\.$/, () => '有动画没有带动场景中的任何物体，已略去。'],
  [/^The attribute (\S+) of instances is left out\.$/, (name) => `略去了实例的属性 ${name}。`],
  [/^The attribute (\S+) is left out\.$/, (name) => `略去了顶点属性 ${name}。`],
  [/^The range of a light is not used/, () => '不采用光源的作用范围：光会像真实的光一样逐渐减弱，不会截断。'],
  [/^Occlusion textures are kept but not used/, () => '遮蔽贴图不参与计算：路径追踪会自行求出角落处的光照。'],
  [/^The file has more scenes than one; scene (\d+)(.*) is not shown\.$/, (n, name) => `文件含有多个场景，未显示场景 ${n}${name}。`], // biome-ignore format: one line each
  [
    /^A node says that it and all that it carries are not visible/,
    () => '有节点被标为不可见，连同其下的内容一并略去。',
  ],
  [/^A node of the scene is carried by one that is not in the scene/, () => '场景的节点由不在场景中的节点承载，按独立节点处理。'], // biome-ignore format: one line each
  [/^A scale is 0 along some axes/, () => '有缩放在某些轴上为 0，按最大分量的万分之一处理。'],
  [/^Nothing in the file has a surface/, () => '文件中没有任何表面，因此没有可见的物体。'],
  [/^A rotation is no unit quaternion/, () => '有旋转不是单位四元数，已归一化。'],
  [/^The scene shown uses some of the file's (\w+) only\.$/, (list) => `当前场景只用到文件中的一部分 ${list}。`],
  [/^(\S+) is (\S+) where (\S+) to (\S+) is allowed; it counts as (\S+)\.$/, (what, value, least, most, kept) => `${what} 的值 ${value} 超出 ${least} 到 ${most} 的范围，按 ${kept} 处理。`], // biome-ignore format: one line each
  [
    /^A node has a skin, but its mesh no joints/,
    () => '有节点指定了蒙皮，但其网格没有关节和权重，因此网格直接跟随节点运动。',
  ],
  [
    /^A material has a normal map or anisotropy/,
    () => '有材质使用法线贴图或各向异性，但网格没有纹理坐标，因此不起作用。',
  ],
  [
    /^The diffuse texture of a specular-glossiness material lies otherwise/,
    () => '高光—光泽度材质的漫反射贴图与高光贴图铺法不同，只按菲涅耳项减弱漫反射。',
  ],
  [
    /^A clear coat's normal map goes by other coordinates/,
    () => '清漆法线贴图与底层法线贴图使用的纹理坐标不同；两者都以底层的切线为准。',
  ],
  [/^The extension (\S+) is not read\.$/, (name) => `不支持扩展 ${name}。`],
  [/^Images of the kind (\S+) cannot be decoded here; the texture is left out\.$/, (type) => `此处无法解码 ${type} 图片，略去了该贴图。`], // biome-ignore format: one line each
  [/^Images of the kind (\S+) cannot be decoded here; another image/, (type) => `此处无法解码 ${type} 图片，改用该贴图的备用图片。`], // biome-ignore format: one line each
  [
    /^(\d+) of its numbers are negative, which light is not/,
    (count) => `全景图中有 ${count} 个负数，光不能为负，均按 0 处理。`,
  ],
  [
    /^It has (\d+ × \d+) texels and is averaged to (\d+ × \d+), as (\d+ × \d+) are/,
    (size, less, most) => `全景图为 ${size} 像素，超过了上限 ${most}，已缩小为 ${less}。`,
  ],
  [/^A texture has no image; it is left out\.$/, () => '有贴图缺少图片，已略去。'],
  [/^Meshes have two sets of texture coordinates/, () => '网格只支持 0、1 两组纹理坐标，略去了使用其他坐标的贴图。'],
  [/^Channels of (\d+) bits are rounded to 8\.$/, (bits) => `${bits} 位的颜色通道已取整为 8 位。`],
  [/^Light meets surfaces only: (\S+) are left out\.$/, (what) => `光线只与表面相交，略去了 ${what}。`],
  [/^A primitive has no positions; it is left out\.$/, () => '有图元没有顶点位置，已略去。'],
  [/^A primitive has not enough vertices for a triangle/, () => '有图元的顶点不足以组成三角形，已略去。'],
  [/^(\d+) indices make no whole triangles/, (count) => `${count} 个索引不能组成完整的三角形，略去了末尾的几个。`],
  [/^(\d+) normals have no direction/, (count) => `${count} 个法线没有方向，改用周围三角形的法线。`],
  [/^(\d+) tangents have no direction or no hand/, (count) => `${count} 个切线没有方向或手性，已另行计算。`],
  [/^(\d+) numbers of vertex colours are cut to 0 … 1\.$/, (count) => `${count} 个顶点颜色数值已限制在 0 到 1 之间。`],
  [
    /^The weights of (\d+) vertices do not add up to 1/,
    (count) => `${count} 个顶点的蒙皮权重之和不为 1，已按比例调整。`,
  ],
  [/^A morph target bends normals that its mesh does not have\.$/, () => '有变形目标改变法线，但网格没有法线。'],
  [/^Several files could be opened; this is (".*")\. The others are left out: (.*)\.$/, (file, others) => `有多个文件可以打开，当前显示 ${file}，其余未打开：${others}。`], // biome-ignore format: one line each
  [/^The file of materials (".*") cannot be read, so that what it describes is grey: .*$/, (file) => `找不到材质文件 ${file}，其描述的材质显示为灰色。请把它和模型一起打开。`], // biome-ignore format: one line each
  [
    /^The materials are those of (".*"), which is called like the model\.$/,
    (file) => `材质取自与模型同名的文件 ${file}。`,
  ],
  [/^No file describes the material (".*"); it is grey\.$/, (name) => `没有文件描述材质 ${name}，显示为灰色。`],
  [
    /^Nothing is made of (.*) of the material (".*")\.$/,
    (words, name) =>
      `材质 ${name} 的 ${words.replaceAll(/\(("[^"]*") is no image of a kind that is read\)/g, '（$1 的图片格式不受支持）')} 未被采用。`,
  ],
  [/^The image (".*") cannot be read, so that what it covers is plain: .*$/, (file) => `无法读取图像 ${file}，用到它的表面没有贴图。请确认它完好，并和模型一起打开。`], // biome-ignore format: one line each
  [/^The material (".*") has textures, and its triangles have no texture coordinates\.$/, (name) => `材质 ${name} 有贴图，但它的三角形没有纹理坐标。`], // biome-ignore format: one line each
  [/^The same is true of (\d+) more materials\.$/, (count) => `还有 ${count} 种材质也是如此。`],
  [/^Nothing is made of its lines (.*)\.$/, (lines) => `文件中的 ${lines} 行未被采用。`],
];

export function reportInChinese({ message, count }: ReportEntry): string {
  const places = count > 1 ? `（共 ${count} 处）` : '';
  for (const [pattern, say] of forms) {
    const match = pattern.exec(message);
    if (match) return say(...match.slice(1).map((part) => part ?? '')) + places;
  }
  return message + places;
}
