import type { Problem } from 'mirrorball';

/**
 * Problems of scene files in Chinese. The reader tells them in English phrases of few forms; here stands each form, and a phrase of
 * none of them stays as it is. What a property is for is left out: the path before it says which one is meant.
 */

type Form = readonly [pattern: RegExp, say: (...parts: string[]) => string];

/** `"a", "b" or "c"`: names in quotes, which stay as they are. */
const listed = (names: string): string => names.replace(/ (?:or|and) (?=")|, (?=")/g, '、');

/** What things of a scene are called. */
const KINDS: Readonly<Record<string, string>> = {
  material: '材质',
  mesh: '网格',
  node: '节点',
  skin: '蒙皮',
  image: '图片',
  texture: '贴图',
  shape: '形体',
  clip: '动画片段',
};

const allowedForms: readonly Form[] = [
  [/^(?:.*: )?a number from (\S+) to (\S+)$/, (low, high) => `${low} 到 ${high} 之间的数`],
  [/^(?:.*: )?a whole number from (\S+) to (\S+)$/, (low, high) => `${low} 到 ${high} 之间的整数`],
  [
    /^one number of .*: from (\S+) to (\S+) and not nearer to 0 than (\S+)$/,
    (low, high, least) => `${low} 到 ${high} 之间、绝对值不小于 ${least} 的数`,
  ],
  [
    /: a list of three numbers, each from (\S+) to (\S+) and not nearer to 0 than (\S+)$/,
    (low, high, least) => `由三个数组成的列表，每个数在 ${low} 到 ${high} 之间，绝对值不小于 ${least}`,
  ],
  [
    /: a list of (\d+) numbers, each from (\S+) to (\S+)$/,
    (count, low, high) => `由 ${count} 个数组成的列表，每个数在 ${low} 到 ${high} 之间`,
  ],
  [
    /^(?:.*: )?-1 for no limit, or a whole number from (\S+) to (\S+)$/,
    (low, high) => `-1（不限），或 ${low} 到 ${high} 之间的整数`,
  ],
  [/^one number of .*: from (\S+) to (\S+)$/, (low, high) => `${low} 到 ${high} 之间的数`],
  [
    /: a list of three numbers, each from (\S+) to (\S+)$/,
    (low, high) => `由三个数组成的列表，每个数在 ${low} 到 ${high} 之间`,
  ],
  [/: a text of at most (\S+) characters$/, (most) => `不超过 ${most} 个字符的文本`],
  [/(?:^|: )true or false$/, () => 'true 或 false'],
  [/^a name: 1 to (\d+) characters/, (most) => `1 到 ${most} 个字符的名称，不能换行，首尾不能有空格`],
  [/ by name, at most (\d+) of them$/, (most) => `以名称为键的对象，最多 ${most} 项`],
  [/: a list of 1 to (\d+) keys$/, (most) => `1 到 ${most} 个关键帧组成的列表`],
  [/: a list of at most (\d+) tracks$/, (most) => `最多 ${most} 条轨道组成的列表`],
  [/: a number or a list of three numbers$/, () => '一个数，或由三个数组成的列表'],
  [
    /^the sky: one colour \[red, green, blue\], or an object with (.*), or with (".*")$/,
    (names, image) => `一个颜色 [红, 绿, 蓝]，或含有 ${listed(names)} 的对象，或含有 ${image} 的对象`,
  ],
  [
    /^the name of a panorama file, (.*) or (\S+), relative to the scene's folder/,
    (endings, last) =>
      `全景图片的文件名（${endings.replaceAll(', ', '、')} 或 ${last}），路径相对于场景所在的文件夹，用 "/" 分隔`,
  ],
  [
    /^the name of a file with (triangles|an image|a model), (.*) or (\S+), relative to the scene's folder.*?(\(.glb.*)?$/,
    (what, endings, last, models) =>
      `${{ triangles: '三角形网格', 'an image': '图片', 'a model': '模型' }[what]}的文件名（${endings.replaceAll(', ', '、')} 或 ${last}），路径相对于场景所在的文件夹，用 "/" 分隔${models === '' ? '' : '（.glb 和 .gltf 请写在 "models" 里）'}`,
  ],
  [
    /^the name of a material; a mesh that is all of a file/,
    () => '材质的名称；只有取用整个文件、只放置一次且不用矩阵放置的网格，才可省略而使用文件自带的材质',
  ],
  [/: the name of its file, or an object with (.*)$/, (name) => `文件名，或含有 ${name} 的对象`],
  [
    /^a texture: its name, the name of an image or of its file, or an object with (.*)$/,
    (name) => `贴图的名称、图片的名称或图片的文件名，或含有 ${name} 的对象`,
  ],
  [/: 0 or 1$/, () => '0 或 1'],
  [/^the index of refraction: a number from 1 to 4, or 0/, () => '1 到 4 之间的数，或 0（无穷大）'],
  [/^the turn: three angles/, () => '绕 X、Y、Z 轴依次旋转的三个角度，或四元数的四个数'],
  [
    /: a list of numbers, each from (\S+) to (\S+), or of lists of them$/,
    (low, high) => `由 ${low} 到 ${high} 之间的数组成的列表，可以分组`,
  ],
  [/^a place: 12 numbers/, () => '矩阵三行的 12 个数，或含有 "translation"、"rotation" 或 "scale" 的对象'],
  [/: a list of 1 to (\S+)$/, (most) => `1 到 ${most} 项组成的列表`],
  [/: a list of at most (\S+)$/, (most) => `最多 ${most} 项组成的列表`],
  [/: a list of at least (\S+)$/, (least) => `至少 ${least} 项组成的列表`],
  [/^nothing, as "matrix" says where the node is$/, () => '空（不必填写，"matrix" 已经给出了节点的位置）'],
  [/^(\d+) numbers, 12 for each of its joints$/, (count) => `${count} 个数，每个关节 12 个`],
  [
    /^(at least one key and )?(\d+) numbers for each of (\d+) times(, three times over)?$/,
    (key, width, times, cubic) =>
      `${key === '' ? '' : '至少一个关键帧，且'}${times} 个时刻各 ${width} 个数${cubic === '' ? '' : '的三倍'}`,
  ],
  [/^times that never decrease$/, () => '不递减的时间'],
  [/^a node that it does not carry$/, () => '不是它自己下级的节点'],
  [/^a node that moves, turns or evenly scales it$/, () => '只移动、旋转或均匀缩放它的节点'],
  [/^a variant: an object with materials by the names of shapes$/, () => '以形体名称为键、材质名称为值的对象'],
  [/^a pointer to numbers under (.*)$/, (names) => `JSON Pointer，指向 ${listed(names)} 之下的数`],
  [/^no "part", as the file has none$/, () => '空（该文件没有分部，请去掉 "part"）'],
  [/^no "variant", as the file has none$/, () => '空（该文件没有其他外观方案，请去掉 "variant"）'],
  [/^a glTF 2\.0 file that can be read$/, () => '可以读取的 glTF 2.0 文件'],
  [/^at most (\d+) bytes$/, (most) => `最多 ${most} 字节`],
  [/^at most (\d+)$/, (most) => `最多 ${most} 个`],
  [/^fewer of them$/, () => '更少的数量'],
  [/^the last row 0 0 0 1$/, () => '最后一行 0 0 0 1'],
  [/^three columns that do not lie in one plane$/, () => '不在同一平面内的三列'],
  [
    /^nothing, as it belongs to an "image" and the sky has none$/,
    () => '空（它要和 "image" 一起用，而这里的天空没有图片）',
  ],
  [/^the metal: (.*), or an object with (.*)$/, (metals, names) => `${listed(metals)}，或含有 ${listed(names)} 的对象`],
  [/: an object whose "type" is (.*)$/, (names) => `"type" 为 ${listed(names)} 之一的对象`],
  [/: an object with (.*)$/, (names) => `含有 ${listed(names)} 的对象`],
  [/: an object$/, () => '一个对象'],
  [/^(?:[^"]*: )?("[^"]*")$/, (name) => name],
  [/^(?:[^"]*: )?("[^"]*"(?:, | or )"[^"]*".*)$/, (names) => `${listed(names)} 之一`],
  [/^the version of the file format, which is 1$/, () => '文件格式的版本号 1'],
  [/^a point at least (\S+) metres from "eye"$/, (least) => `与 "eye" 相距至少 ${least} 米的点`],
  [/^a direction across the line from "eye" to "target"$/, () => '与视线（从 "eye" 到 "target"）不平行的方向'],
  [/^at least one shape or a visible light$/, () => '至少一个形体或一个可见的光源'],
  [/^at most (\d+) of this type$/, (most) => `这种形体最多 ${most} 个`],
  [/^at most (\d+) of these types$/, (most) => `这两种光源合计最多 ${most} 个`],
  [
    /^an? (\w+); this scene has none yet$/,
    (kind) => `${KINDS[kind] ?? kind}的名称，而此场景还没有定义任何${KINDS[kind] ?? kind}`,
  ],
  [/^one of (.*) and (\d+) more$/, (names, more) => `${listed(names)} 或另外 ${more} 个名称之一`],
  [/^one of (.*)$/, (names) => `${listed(names)} 之一`],
  [/^a material of another type than "dielectric"$/, () => '"dielectric" 以外的材质'],
  [
    /^a material without "transmission" and "diffuseTransmission"$/,
    () => '没有 "transmission" 和 "diffuseTransmission" 的材质',
  ],
  [/^a material without "emission"$/, () => '不带 "emission" 的材质'],
  [/^0 for a plane$/, () => '0（平面不能发光）'],
  [/^a direction of length (\S+) or more$/, (least) => `长度不小于 ${least} 的方向`],
  [
    /^a side that is not along "u", both at least (\S+) metres long$/,
    (least) => `与 "u" 不平行的边，两条边都不短于 ${least} 米`,
  ],
  [/^a time after (\S+)$/, (before) => `晚于 ${before} 的时间`],
  [/^a target of its own$/, () => '其他轨道没有使用的目标'],
  [
    /^a pointer to a number or a triple of numbers under (.*)$/,
    (names) => `JSON Pointer，指向 ${listed(names)} 之下的一个数或三个数`,
  ],
  [/^the keys (.*?)(?:\. Did you mean .*)?$/, (names) => `以下键之一：${listed(names)}`],
  [/^another name$/, () => '别的名称'],
  [/^names that can be told apart$/, () => '能够区分的名称'],
  [/^at most (\d+) values$/, (most) => `最多 ${most} 个值`],
  [/^at most (\d+) characters$/, (most) => `最多 ${most} 个字符`],
  [/^a scene$/, () => '一个场景'],
  [/^each key once$/, () => '每个键只出现一次'],
  [/^a value$/, () => '一个值'],
  [/^less nesting$/, () => '更少的嵌套层数'],
  [/^a key in double quotes$/, () => '用双引号括起来的键'],
  [/^the end of the file$/, () => '文件结尾'],
  [/^a text that ends with a double quote on its own line$/, () => '在同一行内以双引号结束的文本'],
  [/^one of (\\.*)$/, (escapes) => `${escapes} 之一`],
  [/^JSON text that this browser can read$/, () => '浏览器能够解析的 JSON 文本'],
  [
    /^a \.glb or \.gltf model, .* with one of these$/,
    () => '.glb 或 .gltf 模型，.ply、.obj 或 .stl 文件，scene.json，或含有其中之一的 .zip',
  ],
  [/^a whole \.hdr, \.exr, \.npy or \.pfm picture$/, () => '完整的 .hdr、.exr、.npy 或 .pfm 图片'],
  [/^a whole \.zip archive$/, () => '完整的 .zip 压缩包'],
  [/^a file that can be read$/, () => '能够读取的文件'],
  [/^files that come together$/, () => '一起打开的全部文件'],
  [/^the name of a file in the folder of the glTF file or below$/, () => 'glTF 文件所在的文件夹或其子文件夹中的文件名'],
  [/^a whole (image\/\S+)$/, (type) => `完整的 ${type} 图片`],
  [/^what can be$/, () => '能够绘制的场景'],
  [/^a glTF 2\.0 file$|^a glTF file, version "2\.0"$/, () => 'glTF 2.0 文件'],
  [/^0 0 0 1 there$/, () => '0 0 0 1'],
  [/^(\d+) to (\d+), as there are (\d+) elements$/, (from, to, count) => `${from} 到 ${to}（共有 ${count} 个元素）`],
  [/^a GLB, which begins with "glTF", or JSON$/, () => '以 "glTF" 开头的 GLB，或 JSON'],
  [/^a GLB, or JSON as UTF-8$/, () => 'GLB，或 UTF-8 编码的 JSON'],
  [/^a GLB of at least (\d+) bytes$/, (least) => `不少于 ${least} 字节的 GLB`],
  [/^the (\d+) bytes that its head tells$/, (bytes) => `文件头中声明的 ${bytes} 字节`],
  [/^at most (\S+)(?: bytes| of them)?$/, (most) => `不超过 ${most}`],
  [/^an object$/, () => '一个对象'],
  [/^JSON, here (.*)$/, (expected) => `JSON，此处应为${allowedInChinese(expected)}`],
  [/^extensions that Mirrorball knows: (.*)$/, (names) => `Mirrorball 支持的扩展：${names}`],
];

/** Each with a verb of its own. */
const foundForms: readonly Form[] = [
  [/^(\d+) numbers$/, (count) => `有 ${count} 个数`],
  [/^images of (\d+) bytes once they are decoded$/, (bytes) => `图片解码后共 ${bytes} 字节`],
  [/^(\d+) lights together with those of the scene$/, (count) => `连同场景自带的共有 ${count} 个光源`],
  [/^(\d+) placed meshes together with those of the scene$/, (count) => `连同场景自带的共摆放了 ${count} 个网格`],
  [/^the text (".*")$/, (text) => `值为文本 ${text}`],
  [/^an object \((.*)\)$/, (kind) => `值为对象（${kind}）`],
  [/^an object$/, () => '值为对象'],
  [/^a list of (\d+) items$/, (count) => `值为含 ${count} 项的列表`],
  [/^a function$/, () => '值为函数'],
  [/^a symbol$/, () => '值为 Symbol'],
  [/^a BigInt$/, () => '值为 BigInt'],
  [/^the place of the eye$/, () => '与 "eye" 重合'],
  [/^no shape, and no visible light$/, () => '没有形体，也没有可见的光源'],
  [/^(\d+) shapes of type (".*")$/, (count, type) => `有 ${count} 个 ${type} 形体`],
  [/^(\d+) lights of the types "sphere" and "quad"$/, (count) => `有 ${count} 个 "sphere" 或 "quad" 光源`],
  [/^more than (\d+) names$/, (most) => `名称超过 ${most} 个`],
  [/^the name (".*")$/, (name) => `名称为 ${name}`],
  [
    /^(\d+) (vertices|triangles) together, where at most (\d+) are allowed$/,
    (count, kind, most) => `总共有 ${count} 个${kind === 'vertices' ? '顶点' : '三角形'}，超过了上限 ${most} 个`,
  ],
  [/^the last row (.*)$/, (row) => `最后一行为 ${row}`],
  [/^columns that lie in one plane$/, () => '前三列在同一平面内'],
  [/^the (?:dielectric|transparent) material (".*")$/, (name) => `使用了透光的材质 ${name}`],
  [/^the shining material (".*")$/, (name) => `使用了发光的材质 ${name}`],
  [/^u = (\[.*\]) and v = (\[.*\]), which span no area$/, (u, v) => `u = ${u} 与 v = ${v} 围不成面积`],
  [/^(\S+) after (\S+)$/, (time, before) => `时间 ${time} 排在 ${before} 之后`],
  [/^(".*"), which track (\d+) moves already$/, (pointer, track) => `${pointer} 已由轨道 ${track} 控制`],
  [/^the target (".*")$/, (pointer) => `目标为 ${pointer}`],
  [/^the file (".*"), which cannot be used \((.*)\)$/, (file, reason) => `文件 ${file} 无法使用（${reason}）`],
  [/^the unknown key (".*")$/, (key) => `含有未知的键 ${key}`],
  [/^the reserved name (".*")$/, (name) => `使用了保留的名称 ${name}`],
  [/^a name that looks the same as another, (".*")$/, (name) => `有两个看起来相同的名称 ${name}`],
  [/^too many values$/, () => '值太多'],
  [/^(\d+) characters$/, (count) => `有 ${count} 个字符`],
  [/^\[(.*the text .*)\]$/, (items) => `值为 [${items.replaceAll('the text "', '文本 "')}]`],
  [/^something that throws when it is read$/, () => '读取时出错'],
  [/^something that cannot be read$/, () => '无法读取'],
  [/^nothing more at line (\d+), column (\d+)$/, (line, column) => `到第 ${line} 行第 ${column} 列就结束了`],
  [/^(".*") at line (\d+), column (\d+)$/, (text, line, column) => `第 ${line} 行第 ${column} 列是 ${text}`],
  [/^the same key again, in line (\d+)$/, (line) => `第 ${line} 行重复了同样的键`],
  [/^no file$/, () => '文件夹或压缩包是空的'],
  [/^a file of another kind$/, () => '文件类型不受支持'],
  [/^a model of another kind \((\.\w+)\)$/, (ending) => `${ending} 模型无法直接打开（请先在原来的软件中导出为 glTF）`],
  [/^a panorama that cannot be used \((.*)\)$/s, (reason) => `全景图无法使用（${pictureInChinese(reason)}）`],
  [/^(\d+) files of other kinds$/, (count) => `${count} 个文件的类型都不受支持`],
  [/^an archive that cannot be opened: (.*)$/, (reason) => `压缩包无法打开（${reason}）`],
  [/^a file that cannot be read \((.*)\)$/, (reason) => `文件无法读取（${reason}）`],
  [/^the file (".*"), which cannot be read \(it is missing: .*\)$/, (file) => `缺少文件 ${file}，请把它一起打开`],
  [/^the file (".*"), which cannot be read \((.*)\)$/, (file, reason) => `文件 ${file} 无法读取（${reason}）`],
  [/^the file (".*"), which has not been given$/, (file) => `缺少文件 ${file}`],
  [/^the image (".*"), which cannot be decoded \((.*)\)$/, (name, reason) => `图片 ${name} 无法解码（${reason}）`],
  [/^what cannot be drawn here$/, () => '此处无法绘制'],
  [/^bytes that are no text$/, () => '内容不是文本'],
  [/^bytes that are no image$/, () => '内容不是图片'],
  [/^a ([A-Z]+) image$/, (kind) => `图片是（${kind}）格式`],
  [/^a (\w+) image that is damaged or cut off in its head$/, (kind) => `（${kind}）图片的文件头已损坏或不完整`],
  [/^an empty file$/, () => '文件是空的'],
  [/^a pointer of Git LFS, not the file that it stands for$/, () => '这只是（Git LFS）指针，不是文件本身'],
  [/^a web page$/, () => '这是一个网页'],
  [/^a matrix whose last row is (.*)$/, (row) => `矩阵的最后一行是 ${row}`],
  [/^the place (\d+)$/, (place) => `位置为 ${place}`],
  [/^(\d+) bytes, so it is cut off$/, (bytes) => `只有 ${bytes} 字节，文件不完整`],
  [/^(\d+) bytes$/, (bytes) => `有 ${bytes} 字节`],
  [/^(\d+) bytes, where there are (\d+)$/, (claimed, there) => `声称有 ${claimed} 字节，实际只有 ${there} 字节`],
  [/^something that cannot be read \((.*)\)$/, (reason) => `内容无法读取（${reason}）`],
  [/^the extension (".*"), without which it cannot be read$/, (name) => `必须支持扩展 ${name} 才能读取`],
  [/^no version$/, () => '没有版本号'],
  [/^nothing$/, () => '缺少此项'],
  [/^(.*)$/s, (value) => `值为${spaced(value)}`],
];

/** Between Chinese and anything else stands a space. */
const spaced = (phrase: string): string => (/^[!-~]/.test(phrase) ? ` ${phrase}` : phrase);

function translate(phrase: string, forms: readonly Form[]): string {
  for (const [pattern, say] of forms) {
    const match = pattern.exec(phrase);
    if (match) return say(...match.slice(1).map((part) => part ?? ''));
  }
  return phrase;
}

export const foundInChinese = (found: string): string => translate(found, foundForms);
export const allowedInChinese = (allowed: string): string => translate(allowed, allowedForms);

/** What readers of pictures throw: whoever opens one wants to know whether to fetch it again or to save it otherwise. */
const pictureForms: readonly Form[] = [
  [/^The (HDR|EXR|NPY|PFM) (?:first line|start of the file) has /, (kind) => `这不是 ${kind} 文件`],
  [/^The EXR file has .*; expected scan lines of flat pixels in one part$/, () => '只支持单部分、按扫描行存储的 EXR'],
  [/^The (?:HDR|EXR|NPY|PFM) .* has (?:\d+ bytes?|no bytes|a text without end)/, () => '文件已损坏或不完整'],
  [/^The picture of a sky has the channels (.*); expected/, (names) => `通道为 ${names}，只支持 R G B 或单个通道`],
  [
    /^The picture of a sky has the value (\S+) in column (\d+) of row (\d+)/,
    (value, column, row) => `第 ${row} 行第 ${column} 列的值 ${value} 不是有效的亮度`,
  ],
];
const pictureInChinese = (reason: string): string => translate(reason, pictureForms);

const drawingForms: readonly Form[] = [
  [
    /^The (meshes|textures) of this scene need (.*); this device has room for (.*) \((.*)\)\.$/,
    (what, need, room, limit) =>
      `场景的${what === 'meshes' ? '网格' : '贴图'}需要 ${need}，而此设备最多容纳 ${room}（${limit}）。`,
  ],
  [
    /^The shape (".*") is a mesh; on a GPU only the path integrator .*$/,
    (name) => `形体 ${name} 是三角形网格，GPU 上只有路径追踪能够绘制（"render": { "integrator": "path" }）。`,
  ],
  [
    /^A ray may have to remember (\d+) nodes .* remember (\d+)\.$/,
    (need, room) => `网格的加速结构过深，需要记住 ${need} 个节点，最多只能记住 ${room} 个。`,
  ],
];
const drawingInChinese = (message: string): string => translate(message, drawingForms);

/** One sentence that says where, what was found and what may stand there. */
export function problemInChinese({ path, found, allowed, message }: Problem): string {
  const beyond = /^(\d+) more$/.exec(found);
  if (beyond) return `……另有 ${beyond[1]} 个问题。`;
  // What draws it says why in a sentence of its own.
  if (found === 'what cannot be drawn here') return `此处无法绘制：${drawingInChinese(message)}`;
  const place = path === '' ? '' : `在 ${path} 处：`;
  const meant = /Did you mean (".+")\?$/.exec(message);
  return `${place}${foundInChinese(found)}，应为${spaced(allowedInChinese(allowed))}。${meant ? `你是不是想写 ${meant[1]}？` : ''}`;
}
