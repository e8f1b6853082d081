/** docs/proof/index.html: static, read without a script. */
import { LIMITS, type ZTest } from '../../tests/reference/statistics.ts';
import { chart } from './chart.ts';
import type { Convergence } from './convergence.ts';

/** What docs/proof/results.json holds of a scene. */
export interface SceneProof
  extends Pick<ZTest, 'rms' | 'shareBeyond3' | 'largest' | 'blockError' | 'picture' | 'failures'> {
  readonly name: string;
  readonly description: string;
  readonly backend: string;
  readonly batches: number;
  /** Samples a pixel of all batches together. */
  readonly samples: number;
  readonly convergence: Convergence;
}

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
const share = (x: number, digits = 2): string => `${(100 * x).toFixed(digits)} %`;

export function proofPage(scenes: readonly SceneProof[]): string {
  const passed = scenes.filter(({ failures }) => failures.length === 0).length;
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Mirrorball: the path integrator against references</title>
<style>${CSS}</style>
</head>
<body>
<h1>The path integrator against references</h1>
<p>${passed} of ${scenes.length} scenes agree with pictures of the same scenes that Mitsuba 3.9.1 made, a renderer that shares no
code with Mirrorball. The test has no threshold on pixels. It asks whether what differs can be noise: for each block of 4 × 4
pixels and each channel,</p>
<p class="formula">z = (ours − reference) / √(error of ours² + error of the reference²)</p>
<p>If both renderers compute the same light, z is normal with variance 1 in every scene. Required: root mean square of z at
most ${LIMITS.rms}; at most ${share(LIMITS.shareBeyond3, 1)} beyond 3; none beyond ${LIMITS.largest}; the mean of the whole picture
within ${LIMITS.picture} errors; and noise small enough to tell, at most ${share(LIMITS.blockError, 0)} of a block. Errors of ours are the
scatter of independent batches, with Student's t turned to z. <code>npm run proof</code> writes this page;
<a href="../../tests/reference/README.md">tests/reference</a> says where the references come from.</p>
<p lang="zh-CN"><strong>摘要：</strong>${scenes.length} 个场景中有 ${passed} 个与 Mitsuba 3.9.1 的参考图一致。两者没有共用代码。检验不用像素阈值，而是看差异能否只由噪声解释：每个 4 × 4 像素块、每个通道计算 z = 差 / 合并标准误差。若两者计算同样的光，z 服从标准正态分布。右边的曲线是误差随采样数的变化（双对数坐标），虚线为斜率 −½。</p>
<p class="legend">z-map: <span class="red">red</span> ours too bright, <span class="blue">blue</span> too dark, full colour at 4, light grey none; a
right picture is a faint speckle without a shape. Chart: relative error (root of relMSE) of one sequence of samples;
dashed the slope −½; dotted the reference's own noise.</p>
${scenes.map(section).join('\n')}
</body>
</html>
`;
}

function section(scene: SceneProof): string {
  const { name, description, failures, picture } = scene;
  const verdict = failures.length === 0 ? '<span class="pass">agrees</span>' : '<span class="fail">differs</span>';
  const figure = (file: string, caption: string) =>
    `<figure><img src="${name}-${file}.png" width="144" height="144" alt="${escaped(name)}, ${caption}"><figcaption>${caption}</figcaption></figure>`;
  const rows = [
    ['samples a pixel', `${scene.samples} in ${scene.batches} batches, ${scene.backend}`],
    ['z, root mean square', scene.rms.toFixed(2)],
    ['z beyond 3', share(scene.shareBeyond3)],
    ['largest |z|', scene.largest.toFixed(1)],
    ['error of a block', share(scene.blockError)],
    ...picture.map(({ difference, error }, c) => [
      `whole picture, ${['red', 'green', 'blue'][c]}`,
      `${difference < 0 ? '−' : '+'}${share(Math.abs(difference), 3)} ± ${share(error, 3)}`,
    ]),
  ];
  return `<section id="${name}">
<h2>${name} ${verdict}</h2>
<p>${escaped(description)}${failures.length > 0 ? `<br><strong>${escaped(failures.join('; '))}</strong>` : ''}</p>
<div class="row">
${figure('ours', 'ours')}${figure('reference', 'reference')}${figure('z', 'z-map')}
<table>${rows.map(([what, value]) => `<tr><th>${what}</th><td>${value}</td></tr>`).join('')}</table>
${chart(scene.convergence, name)}
</div>
</section>`;
}

const CSS = `
:root { color-scheme: light dark; --text: #1b1b1f; --page: #fff; --faint: #666; --line: #d8d8de; --ours: #1257b0; --pass: #19703a; --fail: #b3261e; }
@media (prefers-color-scheme: dark) {
  :root { --text: #e8e8ec; --page: #141417; --faint: #a0a0a8; --line: #3a3a42; --ours: #7fb4ff; --pass: #6fd08f; --fail: #ff8a80; }
}
body { margin: 2rem auto; padding: 0 1rem; max-width: 76rem; color: var(--text); background: var(--page); font: 16px/1.5 system-ui, sans-serif; }
p { max-width: 48rem; }
a { color: var(--ours); }
.formula { font-family: ui-serif, Georgia, serif; padding-left: 2rem; }
.legend, figcaption { color: var(--faint); font-size: 0.875rem; }
.red { color: var(--fail); } .blue { color: var(--ours); }
section { border-top: 1px solid var(--line); margin-top: 1.5rem; }
h2 span { font-size: 0.875rem; font-weight: 600; }
.pass { color: var(--pass); } .fail { color: var(--fail); }
.row { display: flex; flex-wrap: wrap; gap: 1rem; align-items: flex-start; }
figure { margin: 0; }
img { display: block; image-rendering: pixelated; max-width: 100%; }
table { border-collapse: collapse; font-size: 0.875rem; font-variant-numeric: tabular-nums; }
th { text-align: left; font-weight: normal; color: var(--faint); padding-right: 0.75rem; }
td { text-align: right; }
svg { width: 300px; max-width: 100%; font-size: 11px; }
svg text { fill: var(--faint); }
svg .grid { stroke: var(--line); }
svg .slope { fill: none; stroke: var(--faint); stroke-dasharray: 5 4; }
svg .floor { stroke: var(--faint); stroke-dasharray: 1 4; }
svg .ours { fill: none; stroke: var(--ours); stroke-width: 2; }
svg circle { fill: var(--ours); }
`;
