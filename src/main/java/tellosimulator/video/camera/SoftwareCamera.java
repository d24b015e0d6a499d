package tellosimulator.video.camera;

import java.util.List;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.Scene;

/**
 * A camera that draws a scene without display, graphics card or toolkit. It keeps what it needs for
 * a picture, so that it takes no memory for the next one. For one thread at a time; cameras of
 * several threads share their {@link Props}.
 */
public final class SoftwareCamera {

  private final Props props;
  private final Projection projection = new Projection();
  private final Corners corners = new Corners();
  private final Lighting lighting = new Lighting();
  private final Outline outline = new Outline();
  private final Slopes slopes = new Slopes();
  private final PolygonFiller filler = new PolygonFiller();
  private final Strip strip = new Strip();
  private final PlainBrush plain = new PlainBrush(slopes, strip);
  private final SurfaceBrush surface = new SurfaceBrush(slopes, strip);
  private final DecalBrush decal = new DecalBrush(slopes, strip);
  private final int[] triangle = new int[3];

  public SoftwareCamera(Props props) {
    this.props = props;
  }

  /**
   * Draws what is seen from a place. What is not covered becomes black.
   *
   * @param raster of the size of the viewpoint's lens, and of the colour space of the props
   */
  public void draw(Scene scene, Viewpoint viewpoint, Raster raster) {
    Lens lens = viewpoint.lens();
    if (raster.width() != lens.width() || raster.height() != lens.height()) {
      throw new IllegalArgumentException(
          "raster is " + raster.width() + " by " + raster.height() + ", but the lens has " + lens);
    }
    raster.clear();
    begin(viewpoint, raster);
    List<Placed> parts = scene.parts();
    // The room comes first and is behind all else: drawn last, it need not be painted there.
    for (int i = parts.size() - 1; i >= 0; i--) {
      if (!translucent(parts.get(i).part().finish())) {
        draw(parts.get(i));
      }
    }
    for (int i = 0; i < parts.size(); i++) {
      if (translucent(parts.get(i).part().finish())) {
        draw(parts.get(i));
      }
    }
  }

  private void begin(Viewpoint viewpoint, Raster raster) {
    projection.aim(viewpoint);
    filler.size(raster.width(), raster.height());
    strip.room(raster.width());
    plain.on(raster);
    surface.on(raster);
    decal.on(raster);
  }

  private void draw(Placed placed) {
    Shape shape = props.shape(placed.part());
    projection.place(placed);
    if (!projection.sees(shape.middle, shape.radius * placed.scale())) {
      return;
    }
    corners.project(shape, projection);
    Finish finish = placed.part().finish();
    finish.lamps().ifPresent(lamps -> lighting.shine(lamps, shape, placed.pose().attitude()));
    decal.opacity(placed.opacity(), finish == Finish.DECAL);
    drawTriangles(shape, placed.part());
  }

  private void drawTriangles(Shape shape, Part part) {
    boolean lighted = part.finish().lamps().isPresent();
    TextureBrush brush = translucent(part.finish()) ? decal : surface;
    MipMaps texture = null;
    for (int i = 0; i < shape.triangles(); i++) {
      if (!outlined(shape, i)) {
        continue;
      }
      if (lighted) {
        slopes.light(lighting.lights(), shape.normalOf, 3 * i);
      } else {
        slopes.fullLight();
      }
      if (shape.plain[i] && brush == surface) {
        plain.color(props.color(part, shape.places[6 * i], shape.places[6 * i + 1]));
        filler.fill(outline, plain);
        continue;
      }
      if (texture == null) { // not before, as it takes long to make one
        texture = props.texture(part);
        brush.texture(texture, lighted);
      }
      slopes.texture(shape.places, 6 * i, texture);
      filler.fill(outline, brush);
    }
  }

  /** Whether a triangle is seen; then outline and slopes are its own. */
  private boolean outlined(Shape shape, int number) {
    int a = shape.pointOf[3 * number];
    int b = shape.pointOf[3 * number + 1];
    int c = shape.pointOf[3 * number + 2];
    int[] outside = corners.outside;
    if ((outside[a] & outside[b] & outside[c]) != 0) {
      return false;
    }
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
    if (((outside[a] | outside[b] | outside[c]) & Corners.NEAR) != 0) {
      outline.cut(corners, triangle, projection.near());
    } else if (!outline.whole(corners, triangle)) {
      return false;
    }
    return slopes.face(corners.seen, triangle);
  }

  private static boolean translucent(Finish finish) {
    return finish == Finish.DECAL || finish == Finish.SHEER;
  }
}
