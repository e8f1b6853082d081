#version 300 es
// The room as a course project would draw it: scene, intersection and shading all in one fragment shader, every ray
// tried against everything, nine shadow rays to the light from every hit, whatever the light's reach. Deliberately
// plain: this is what Mirrorball is measured against, so nothing here is to be made faster.
precision highp float;
precision highp int;

uniform float side;      // pixels along one side of the square picture
uniform vec3 eye;
uniform int hitLimit;    // surfaces met along a path: 1 = no mirror image at all
out vec4 pixel;

const int MOST_HITS = 10;
const float NOTHING = 1e9;
const float NEAR = 1e-3;

struct Paint { vec3 colour; float mirror; };
struct Ball { vec3 middle; float radius; Paint paint; };
struct Block { vec3 least; vec3 most; Paint paint; };
struct Wall { vec3 facing; float offset; Paint paint; };   // dot(facing, p) = offset
struct Lamp { vec3 middle; vec3 colour; float radius; float strength; vec3 ambient; };
struct Spot { float distance; vec3 facing; Paint paint; };

Ball balls[4];
Block blocks[2];
Wall walls[6];
Lamp lamp;
vec3 lampPoints[9];

void furnish() {
  balls[0] = Ball(vec3(-0.95, 0.45, -1.2), 0.45, Paint(vec3(0.95), 0.8));
  balls[1] = Ball(vec3(0.1, 0.3, 0.2), 0.3, Paint(vec3(0.9, 0.75, 0.2), 0.35));
  balls[2] = Ball(vec3(1.3, 0.35, 0.1), 0.35, Paint(vec3(0.25, 0.55, 0.95), 0.25));
  balls[3] = Ball(vec3(-1.35, 0.25, 0.3), 0.25, Paint(vec3(0.9, 0.3, 0.6), 0.15));
  blocks[0] = Block(vec3(0.35, 0.0, -1.6), vec3(1.15, 1.5, -0.8), Paint(vec3(0.8), 0.1));
  blocks[1] = Block(vec3(-0.7, 0.0, -0.45), vec3(-0.15, 0.6, 0.1), Paint(vec3(0.75, 0.8, 0.7), 0.1));
  walls[0] = Wall(vec3(0.0, 1.0, 0.0), 0.0, Paint(vec3(0.75), 0.25));
  walls[1] = Wall(vec3(0.0, -1.0, 0.0), -3.0, Paint(vec3(0.8), 0.05));
  walls[2] = Wall(vec3(1.0, 0.0, 0.0), -2.0, Paint(vec3(0.8, 0.2, 0.15), 0.05));
  walls[3] = Wall(vec3(-1.0, 0.0, 0.0), -2.0, Paint(vec3(0.2, 0.7, 0.25), 0.05));
  walls[4] = Wall(vec3(0.0, 0.0, 1.0), -3.0, Paint(vec3(0.75), 0.05));
  walls[5] = Wall(vec3(0.0, 0.0, -1.0), -3.0, Paint(vec3(0.7), 0.05));
  lamp = Lamp(vec3(0.0, 2.75, -0.2), vec3(1.0, 0.96, 0.9), 0.5, 22.0, vec3(0.12));
  for (int row = 0; row < 3; row++) {
    for (int column = 0; column < 3; column++) {
      lampPoints[row * 3 + column] = lamp.middle + lamp.radius * 0.5 * vec3(float(column - 1), 0.0, float(row - 1));
    }
  }
}

float reachBall(Ball ball, vec3 from, vec3 along) {
  vec3 away = from - ball.middle;
  float half_b = dot(away, along);
  float inside = half_b * half_b - dot(away, away) + ball.radius * ball.radius;
  if (inside < 0.0) return NOTHING;
  float root = sqrt(inside);
  if (-half_b - root > NEAR) return -half_b - root;
  if (-half_b + root > NEAR) return -half_b + root;
  return NOTHING;
}

float reachBlock(Block block, vec3 from, vec3 along) {
  vec3 a = (block.least - from) / along;
  vec3 b = (block.most - from) / along;
  vec3 entry = min(a, b);
  vec3 leave = max(a, b);
  float first = max(entry.x, max(entry.y, entry.z));
  float last = min(leave.x, min(leave.y, leave.z));
  if (first > last || last < NEAR) return NOTHING;
  return first > NEAR ? first : last;
}

vec3 blockFacing(Block block, vec3 point) {
  vec3 local = (2.0 * point - block.least - block.most) / (block.most - block.least);
  vec3 size = abs(local);
  if (size.x > size.y && size.x > size.z) return vec3(sign(local.x), 0.0, 0.0);
  return size.y > size.z ? vec3(0.0, sign(local.y), 0.0) : vec3(0.0, 0.0, sign(local.z));
}

float reachWall(Wall wall, vec3 from, vec3 along) {
  float slope = dot(wall.facing, along);
  if (abs(slope) < 1e-6) return NOTHING;
  float distance = (wall.offset - dot(wall.facing, from)) / slope;
  return distance > NEAR ? distance : NOTHING;
}

Spot closest(vec3 from, vec3 along) {
  Spot spot;
  spot.distance = NOTHING;
  for (int i = 0; i < 4; i++) {
    float t = reachBall(balls[i], from, along);
    if (t < spot.distance) spot = Spot(t, normalize(from + t * along - balls[i].middle), balls[i].paint);
  }
  for (int i = 0; i < 2; i++) {
    float t = reachBlock(blocks[i], from, along);
    if (t < spot.distance) spot = Spot(t, blockFacing(blocks[i], from + t * along), blocks[i].paint);
  }
  for (int i = 0; i < 6; i++) {
    float t = reachWall(walls[i], from, along);
    if (t < spot.distance) spot = Spot(t, walls[i].facing, walls[i].paint);
  }
  return spot;
}

bool blocked(vec3 from, vec3 along, float limit) {
  for (int i = 0; i < 4; i++) if (reachBall(balls[i], from, along) < limit) return true;
  for (int i = 0; i < 2; i++) if (reachBlock(blocks[i], from, along) < limit) return true;
  for (int i = 0; i < 6; i++) if (reachWall(walls[i], from, along) < limit) return true;
  return false;
}

vec3 light(vec3 point, Spot spot) {
  vec3 sum = vec3(0.0);
  for (int k = 0; k < 9; k++) {
    vec3 way = lampPoints[k] - point;
    float far = length(way);
    way /= far;
    sum += lamp.ambient * spot.paint.colour;
    if (!blocked(point + spot.facing * NEAR, way, far)) {
      float falloff = lamp.strength * lamp.radius * lamp.radius / (far * far);
      sum += spot.paint.colour * lamp.colour * falloff * max(dot(spot.facing, way), 0.0);
    }
  }
  return sum / 9.0;
}

// The curve of an sRGB screen, as Mirrorball uses it, so that the two pictures can be compared number by number.
vec3 screen(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

void main() {
  furnish();
  vec2 at = 2.0 * gl_FragCoord.xy / side - 1.0;
  vec3 ahead = normalize(vec3(0.0, 1.1, -1.0) - eye);
  vec3 right = normalize(cross(ahead, vec3(0.0, 1.0, 0.0)));
  vec3 along = normalize(sqrt(3.0) * ahead + at.x * right + at.y * cross(right, ahead));   // 60° from top to bottom
  vec3 from = eye;
  vec3 colour = vec3(0.0);
  float weight = 1.0;
  for (int hit = 0; hit < MOST_HITS; hit++) {
    if (hit >= hitLimit) break;
    Spot spot = closest(from, along);
    if (spot.distance == NOTHING) break;
    vec3 point = from + spot.distance * along;
    colour += weight * (1.0 - spot.paint.mirror) * light(point, spot);
    weight *= spot.paint.mirror;
    from = point + NEAR * spot.facing;
    along = reflect(along, spot.facing);
  }
  pixel = vec4(screen(colour), 1.0);
}
