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
  private final PlainBrush plain;
  private final PaintedBrush painted;
  private final LitBrush lit;
  private final DecalBrush decal;
  private final int[] triangle = new int[3];

  public SoftwareCamera(Props props) {
    this.props = props;
    plain = new PlainBrush(slopes, props.space());
    painted = new PaintedBrush(slopes);
    lit = new LitBrush(slopes, props.space());
    decal = new DecalBrush(slopes);
  }

  /**
   * Draws what is seen from a place. What is not covered becomes black.
   *
   * @param raster of the size of the viewpoint's lens
   */
  public void draw(Scene scene, Viewpoint viewpoint, Raster raster) {
    Lens lens = viewpoint.lens();
    if (raster.width() != lens.width() || raster.height() != lens.height()) {
      throw new IllegalArgumentException(
          "raster is " + raster.width() + " by " + raster.height() + ", but the lens has " + lens);
    }
    raster.clear(props.space().black());
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
    plain.on(raster);
    painted.on(raster);
    lit.on(raster);
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
    Finish finish = part.finish();
    boolean lighted = finish.lamps().isPresent();
    TextureBrush brush = brush(finish);
    MipMaps texture = null;
    for (int i = 0; i < shape.triangles(); i++) {
      if (!outlined(shape, i)) {
        continue;
      }
      if (texture == null) { // not before, as it takes long to make one
        texture = props.texture(part);
        brush.texture(texture, lighted);
      }
      if (lighted) {
        slopes.light(lighting.lights(), shape.normalOf, 3 * i);
      } else {
        slopes.fullLight();
      }
      if (shape.plain[i] && brush != decal) {
        plain.color(texture.color(shape.places[6 * i], shape.places[6 * i + 1]));
        filler.fill(outline, plain);
      } else {
        slopes.texture(shape.places, 6 * i, texture);
        filler.fill(outline, brush);
      }
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

  private TextureBrush brush(Finish finish) {
    return switch (finish) {
      case PAINTED -> painted;
      case LIT, MATT -> lit;
      case DECAL, SHEER -> decal;
    };
  }
}
