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
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.Texture;
import tellosimulator.scenery.room.PictureShelf;
import tellosimulator.scenery.room.Quads.Quad;
import tellosimulator.world.Cover;
import tellosimulator.world.Cover.Pattern;
import tellosimulator.world.Cover.Side;
import tellosimulator.world.Shape;

/**
 * Makes the parts of obstacles, each in the obstacle's frame. Paint is lit, so that one sees the
 * sides; pictures are as bright as their files, as posters are. For one thread at a time.
 */
final class Workshop {

  /** What carries a gate. Decided: by eye; it shall not be taken for the gate. */
  private static final Rgb POST = Rgb.of(0x44484e);

  /** Around a circle of radius 1. */
  private static final double TURN = 2 * Math.PI;

  private record Paint(Pattern pattern, int rgb) {

    static Paint of(Cover cover) {
      return new Paint(cover.pattern(), cover.rgb());
    }
  }

  private record Size(double width, double height) {}

  private final Map<Paint, Coat> coats = new HashMap<>();
  private final Coat post = Coat.plain(POST);
  private final PictureShelf pictures;
  private final Grit grit;

  /**
   * @param pictures where image files come from
   * @param grit the size of patterns
   */
  Workshop(PictureShelf pictures, Grit grit) {
    this.pictures = pictures;
    this.grit = grit;
  }

  Grit grit() {
    return grit;
  }

  /** Forgets the paint that none of these covers has. */
  void keep(Collection<Cover> covers) {
    coats.keySet().retainAll(paints(covers));
  }

  /** The size of patterns that suits these covers. */
  static Grit grit(Collection<Cover> covers) {
    return Grit.of(paints(covers).stream().filter(paint -> paint.pattern != Pattern.PLAIN).count());
  }

  private static Set<Paint> paints(Collection<Cover> covers) {
    return covers.stream().map(Paint::of).collect(Collectors.toSet());
  }

  /** The parts of an obstacle. */
  List<Part> parts(Shape shape, Cover cover) {
    if (shape instanceof Shape.Box box) {
      return box(box, cover);
    }
    if (shape instanceof Shape.Cylinder cylinder) {
      return cylinder(cylinder, cover);
    }
    if (shape instanceof Shape.Ring ring) {
      return ring(ring, coat(cover));
    }
    return frame((Shape.Frame) shape, coat(cover));
  }

  private Coat coat(Cover cover) {
    return coats.computeIfAbsent(
        Paint.of(cover), paint -> Coat.of(paint.pattern, Rgb.of(paint.rgb), grit));
  }

  private List<Part> box(Shape.Box box, Cover cover) {
    Plank plank = new Plank(Vec3.ZERO, new Vec3(box.depth(), box.width(), box.height()));
    Skin paint = new Skin(coat(cover));
    plank.cover(paint, cover.pictures().keySet());
    List<Part> parts = new ArrayList<>(painted(paint));
    for (Side side : Side.values()) { // in this order, as that of the map is not always the same
      if (cover.pictures().containsKey(side)) {
        Quad quad = plank.side(side);
        Skin picture = picture(cover, side, new Size(quad.right().norm(), quad.up().norm()));
        picture.quad(quad, 0, 0);
        parts.add(part(picture, Finish.PAINTED));
      }
    }
    return parts;
  }

  private List<Part> cylinder(Shape.Cylinder cylinder, Cover cover) {
    double radius = cylinder.radius();
    double height = cylinder.height();
    double around = TURN * radius;
    Skin paint = new Skin(coat(cover));
    Round.disc(paint, radius, 0, false);
    List<Part> pictures = new ArrayList<>();
    if (cover.pictures().containsKey(Side.TOP)) {
      Skin top = picture(cover, Side.TOP, new Size(2 * radius, 2 * radius));
      Round.disc(top, radius, height, true);
      pictures.add(part(top, Finish.PAINTED));
    } else {
      Round.disc(paint, radius, height, true);
    }
    if (cover.pictures().containsKey(Side.FRONT)) {
      Skin wrapped = picture(cover, Side.FRONT, new Size(around, height));
      Round.tube(wrapped, radius, height, around);
      pictures.add(part(wrapped, Finish.PAINTED));
    } else {
      Round.tube(paint, radius, height, paint.coat().closed(around));
    }
    List<Part> parts = new ArrayList<>(painted(paint));
    parts.addAll(pictures);
    return parts;
  }

  private List<Part> ring(Shape.Ring ring, Coat coat) {
    double tube = ring.tube() / 2;
    double middle = ring.middle();
    Skin hoop = new Skin(coat);
    Round.hoop(hoop, ring.radius() + tube, tube, middle);
    Skin stand = new Skin(post);
    double lowest = middle - ring.radius() - ring.tube();
    if (lowest > 0) {
      Round.tube(stand, tube, lowest + tube, TURN * tube);
      Round.disc(stand, tube, 0, false);
    }
    return painted(stand, hoop);
  }

  /** Where the simulation has its beams. */
  private List<Part> frame(Shape.Frame frame, Coat coat) {
    double beam = frame.beam();
    double side = (frame.width() + beam) / 2;
    double top = frame.middle() + frame.opening() / 2;
    double sill = frame.middle() - frame.opening() / 2 - beam;
    double foot = Math.max(0, sill);
    Skin beams = new Skin(coat);
    Skin posts = new Skin(post);
    for (double y : new double[] {side, -side}) {
      plank(new Vec3(0, y, foot), new Vec3(beam, beam, top + beam - foot), beams);
      if (foot > 0) {
        plank(new Vec3(0, y, 0), new Vec3(beam, beam, foot), posts);
      }
    }
    Vec3 crossbar = new Vec3(beam, frame.width(), beam);
    plank(new Vec3(0, 0, top), crossbar, beams);
    if (sill >= 0) {
      plank(new Vec3(0, 0, sill), crossbar, beams);
    }
    return painted(posts, beams);
  }

  private static void plank(Vec3 middle, Vec3 size, Skin skin) {
    new Plank(middle, size).cover(skin, Set.of());
  }

  private Skin picture(Cover cover, Side side, Size size) {
    Texture picture = pictures.of(cover.pictures().get(side)).texture();
    return new Skin(Coat.ofPicture(picture, size.width, size.height));
  }

  private static List<Part> painted(Skin... skins) {
    return Stream.of(skins)
        .filter(skin -> !skin.empty())
        .map(skin -> part(skin, Finish.MATT))
        .toList();
  }

  private static Part part(Skin skin, Finish finish) {
    return new Part(skin.mesh(), skin.coat().texture(), finish);
  }
}
