package tellosimulator.scenery.furniture;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.furniture.TexturedMeshBuilder.Box;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.ImageCache;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.ObstacleAppearance.Side;
import tellosimulator.world.Shape;

/**
 * Builds the parts of obstacles, each in the obstacle's frame. Painted surfaces are lit, so the
 * sides of an obstacle differ in brightness. Images are unlit, so they are as bright as their
 * files, like posters. Not thread-safe.
 */
final class FurnitureBuilder {

  /**
   * Colour of the stand of a gate. Decided: by eye; it must not be confused with the gate itself.
   */
  private static final Rgb STAND = Rgb.of(0x44484e);

  /** Circumference of a circle of radius 1. */
  private static final double TURN = 2 * Math.PI;

  /**
   * The values that determine the paint of an obstacle.
   *
   * @param material material of an obstacle without a pattern; for all others always {@link
   *     ObstacleMaterial#PAINT}
   */
  private record Paint(Pattern pattern, int rgb, ObstacleMaterial material) {

    static Paint of(Shape shape, ObstacleAppearance appearance) {
      return new Paint(
          appearance.pattern(),
          appearance.rgb(),
          appearance.pattern() == Pattern.PLAIN
              ? ObstacleMaterial.of(shape, Rgb.of(appearance.rgb()))
              : ObstacleMaterial.PAINT);
    }

    double period() {
      return material == ObstacleMaterial.SEGMENTS
          ? ObstacleMaterial.SEGMENT
          : PatternTexture.period(pattern);
    }
  }

  private final Map<Paint, TextureMapping> paints = new HashMap<>();
  private final TextureMapping stand;
  private final ImageCache images;
  private final PatternTexture patterns;

  /**
   * Creates a builder without any cached paint.
   *
   * @param images source of image files
   * @param patterns source of the textures of paint
   */
  FurnitureBuilder(ImageCache images, PatternTexture patterns) {
    this.images = images;
    this.patterns = patterns;
    stand =
        TextureMapping.repeating(
            patterns.of(Pattern.PLAIN, STAND, ObstacleMaterial.METAL), PatternTexture.TILE);
  }

  PatternTexture patterns() {
    return patterns;
  }

  /** Evicts all paint that none of these obstacles uses. */
  void keep(Collection<Obstacle> obstacles) {
    paints.keySet().retainAll(paints(obstacles));
  }

  /** Returns textures of a size that suits these obstacles. */
  static PatternTexture patterns(Collection<Obstacle> obstacles) {
    return PatternTexture.forCount(paints(obstacles).size());
  }

  private static Set<Paint> paints(Collection<Obstacle> obstacles) {
    return obstacles.stream()
        .map(obstacle -> Paint.of(obstacle.shape(), obstacle.appearance()))
        .collect(Collectors.toSet());
  }

  /** Returns the parts of an obstacle. */
  List<Part> parts(Shape shape, ObstacleAppearance appearance) {
    return shape.match(
        new Shape.Cases<>(
            box -> box(box, appearance),
            cylinder -> cylinder(cylinder, appearance),
            ring -> ring(ring, paint(ring, appearance)),
            frame ->
                frame(frame, paint(frame, appearance), appearance.pattern() == Pattern.PLAIN)));
  }

  private TextureMapping paint(Shape shape, ObstacleAppearance appearance) {
    return paints.computeIfAbsent(
        Paint.of(shape, appearance),
        paint ->
            TextureMapping.repeating(
                patterns.of(paint.pattern, Rgb.of(paint.rgb), paint.material), paint.period()));
  }

  private List<Part> box(Shape.Box shape, ObstacleAppearance appearance) {
    Box box = new Box(Vec3.ZERO, shape.size());
    TexturedMeshBuilder painted = new TexturedMeshBuilder(paint(shape, appearance));
    painted.box(box, appearance.pictures().keySet());
    List<Part> parts = new ArrayList<>(matte(painted));
    for (Side side : Side.values()) { // in this order, because the map's order varies
      if (appearance.pictures().containsKey(side)) {
        Quad quad = box.side(side);
        TexturedMeshBuilder image = image(appearance, side, quad.right().norm(), quad.up().norm());
        image.quad(quad, 0, 0);
        parts.add(image.build(Shading.UNLIT));
      }
    }
    return parts;
  }

  private List<Part> cylinder(Shape.Cylinder shape, ObstacleAppearance appearance) {
    double radius = shape.radius();
    double height = shape.height();
    double around = TURN * radius;
    TexturedMeshBuilder painted = new TexturedMeshBuilder(paint(shape, appearance));
    CurvedSurfaces.disc(painted, radius, 0, false);
    List<Part> images = new ArrayList<>();
    if (appearance.pictures().containsKey(Side.TOP)) {
      TexturedMeshBuilder top = image(appearance, Side.TOP, 2 * radius, 2 * radius);
      CurvedSurfaces.disc(top, radius, height, true);
      images.add(top.build(Shading.UNLIT));
    } else {
      CurvedSurfaces.disc(painted, radius, height, true);
    }
    if (appearance.pictures().containsKey(Side.FRONT)) {
      TexturedMeshBuilder wrapped = image(appearance, Side.FRONT, around, height);
      CurvedSurfaces.tube(wrapped, radius, height, around);
      images.add(wrapped.build(Shading.UNLIT));
    } else {
      CurvedSurfaces.tube(painted, radius, height, painted.mapping().closed(around));
    }
    List<Part> parts = new ArrayList<>(matte(painted));
    parts.addAll(images);
    return parts;
  }

  private List<Part> ring(Shape.Ring shape, TextureMapping paint) {
    double tube = shape.tube() / 2;
    TexturedMeshBuilder ring = new TexturedMeshBuilder(paint);
    CurvedSurfaces.torus(ring, shape.radius() + tube, tube, shape.middle());
    TexturedMeshBuilder post = new TexturedMeshBuilder(stand);
    if (shape.post() > 0) {
      CurvedSurfaces.tube(post, tube, shape.post() + tube, TURN * tube);
      CurvedSurfaces.disc(post, tube, 0, false);
    }
    return matte(post, ring);
  }

  /**
   * Builds a frame. Below the frame's lower edge, its sides are posts.
   *
   * @param segments whether the texture is turned so that it runs along each beam
   */
  private List<Part> frame(Shape.Frame shape, TextureMapping paint, boolean segments) {
    double post = shape.post();
    TexturedMeshBuilder beams = new TexturedMeshBuilder(paint);
    TexturedMeshBuilder posts = new TexturedMeshBuilder(stand);
    for (Shape.Beam beam : shape.beams()) {
      beams.turn(segments && beam.size().z() > beam.size().y());
      if (beam.base().z() >= post) {
        box(beams, beam.base(), beam.size());
      } else {
        box(beams, beam.base().withZ(post), beam.size().withZ(beam.size().z() - post));
        box(posts, beam.base(), beam.size().withZ(post));
      }
    }
    return matte(posts, beams);
  }

  private static void box(TexturedMeshBuilder mesh, Vec3 foot, Vec3 size) {
    mesh.box(new Box(foot, size), Set.of());
  }

  private TexturedMeshBuilder image(
      ObstacleAppearance appearance, Side side, double width, double height) {
    Texture image = images.get(appearance.pictures().get(side)).texture();
    return new TexturedMeshBuilder(TextureMapping.stretched(image, width, height));
  }

  private static List<Part> matte(TexturedMeshBuilder... meshes) {
    return Stream.of(meshes)
        .filter(mesh -> !mesh.isEmpty())
        .map(mesh -> mesh.build(Shading.MATTE))
        .toList();
  }
}
