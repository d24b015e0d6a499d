package tellosimulator.scenery.room;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.TextureRegion;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.room.CalmTextures.Plaster;
import tellosimulator.world.Decor;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

/**
 * The inside of a room: floor, walls and ceiling, and the decals on them. The room has no outside
 * except the slab on which it stands. From outside, a camera sees through the nearest walls,
 * because their back faces are culled. The parts of the most recent room are cached. Thread-safe.
 */
public final class Interior {

  /**
   * Brightness of the plain side walls, relative to the other walls. They are darker so that the
   * corners are visible. Decided: by eye.
   */
  private static final double SHADE = 0.955;

  /** The uppermost texels of a wall's texture, used for a plain ceiling. */
  private static final TextureRegion CEILING = new TextureRegion(0, 0, 1, 0.001);

  private record RoomKey(Room room, Decor decor) {}

  /** A cache that holds only the value of the most recent key. */
  private static final class Cached<K, V> {

    private final Function<K, V> compute;
    private Optional<K> key = Optional.empty();
    private V value;

    Cached(Function<K, V> compute) {
      this.compute = compute;
    }

    V get(K newKey) {
      if (!key.equals(Optional.of(newKey))) {
        value = compute.apply(newKey);
        key = Optional.of(newKey);
      }
      return value;
    }
  }

  private final Cached<RoomKey, List<Instance>> instances = new Cached<>(this::make);
  private final Cached<RoomKey, List<Instance>> onSlab = new Cached<>(this::withSlab);
  private final Posters posters = new Posters();
  private final Cached<Double, Texture> plainFloor = new Cached<>(PlainTextures::floor);
  private final Cached<Double, Texture> texturedFloor = new Cached<>(Parquet.TEXTURED::texture);
  private final Cached<Double, Texture> calmFloor = new Cached<>(Parquet.CALM::texture);
  private final Cached<OptionalInt, Texture> bricks = new Cached<>(AccentBricks::of);
  private final Cached<Plaster, Map<Surface, Texture>> calmWalls =
      new Cached<>(CalmTextures::plastered);
  private final Cached<Double, Texture> plainWall =
      new Cached<>(height -> PlainTextures.wall(height, 1));
  private final Cached<Double, Texture> shadedWall =
      new Cached<>(height -> PlainTextures.wall(height, SHADE));

  /**
   * Returns the parts of the room in drawing order. The list stays the same object until the room
   * or its decor changes.
   */
  public synchronized List<Instance> instances(Room room, Decor decor) {
    return instances.get(new RoomKey(room, decor));
  }

  /** Returns the room on its slab, for cameras that may be outside. */
  public synchronized List<Instance> onSlab(Room room, Decor decor) {
    return onSlab.get(new RoomKey(room, decor));
  }

  private List<Instance> withSlab(RoomKey look) {
    List<Instance> all = new ArrayList<>();
    Slab.parts(look.room).forEach(part -> all.add(Instance.atOrigin(part)));
    all.addAll(instances.get(look));
    return List.copyOf(all);
  }

  private List<Instance> make(RoomKey look) {
    Room room = look.room;
    List<Part> parts =
        switch (look.decor.walls()) {
          case PLAIN -> plain(room, look.decor.grid());
          case TEXTURED -> textured(room, look.decor);
          case AUTO -> calm(room, look.decor);
        };
    List<Part> all = new ArrayList<>(parts);
    all.add(Ruler.part(room, look.decor.walls()));
    all.addAll(posters.parts(room, look.decor.posters()));
    all.sort(Comparator.comparing(part -> part.material().shading())); // decals last
    return List.copyOf(all.stream().map(Instance::atOrigin).toList());
  }

  private List<Part> plain(Room room, double grid) {
    Face floor = Face.of(room, Surface.FLOOR);
    MeshBuilder across =
        new MeshBuilder()
            .quad(Face.of(room, Surface.FRONT_WALL).quad(), TextureRegion.WHOLE)
            .quad(Face.of(room, Surface.BACK_WALL).quad(), TextureRegion.WHOLE)
            .quad(Face.of(room, Surface.CEILING).quad(), CEILING);
    MeshBuilder along =
        new MeshBuilder()
            .quad(Face.of(room, Surface.LEFT_WALL).quad(), TextureRegion.WHOLE)
            .quad(Face.of(room, Surface.RIGHT_WALL).quad(), TextureRegion.WHOLE);
    return List.of(
        painted(
            new MeshBuilder().quad(floor.quad(), centered(floor, grid, 0.5)), plainFloor.get(grid)),
        painted(across, plainWall.get(room.height())),
        painted(along, shadedWall.get(room.height())));
  }

  private List<Part> textured(Room room, Decor decor) {
    Face ceiling = Face.of(room, Surface.CEILING);
    List<Part> parts = new ArrayList<>();
    parts.add(wooden(room, decor.grid(), texturedFloor.get(decor.grid())));
    parts.add(
        painted(
            new MeshBuilder().quad(ceiling.quad(), centered(ceiling, SurfaceTexture.TILE, 0)),
            SurfaceTexture.PANELS.texture()));
    parts.add(wall(Face.of(room, Surface.FRONT_WALL), bricks.get(decor.accent())));
    parts.add(wall(Face.of(room, Surface.BACK_WALL), SurfaceTexture.HEXAGONS.texture()));
    parts.add(wall(Face.of(room, Surface.LEFT_WALL), SurfaceTexture.BOARDS.texture()));
    parts.add(wall(Face.of(room, Surface.RIGHT_WALL), SurfaceTexture.TRIANGLES.texture()));
    parts.add(Trim.skirting(room));
    if (room.height() > 1) {
      parts.add(Trim.lines(room));
    }
    return parts;
  }

  private List<Part> calm(Room room, Decor decor) {
    List<Part> parts = new ArrayList<>();
    parts.add(wooden(room, decor.grid(), calmFloor.get(decor.grid())));
    calmWalls
        .get(new Plaster(room, decor.accent()))
        .forEach((surface, plaster) -> parts.add(plastered(Face.of(room, surface), plaster)));
    parts.add(Trim.skirting(room));
    parts.addAll(RoomWindows.parts(room));
    parts.addAll(RoomDoor.parts(room));
    parts.add(AmbientOcclusion.onFloor(room));
    return parts;
  }

  private static Part wooden(Room room, double grid, Texture texture) {
    Face floor = Face.of(room, Surface.FLOOR);
    int cells = Parquet.cells(grid);
    return painted(
        new MeshBuilder().quad(floor.quad(), centered(floor, cells * grid, 0.5 / cells)), texture);
  }

  private static Part plastered(Face face, Texture plaster) {
    TextureRegion whole = TextureRegion.unwrapped(plaster);
    return painted(new MeshBuilder().quad(face.quad(), whole), plaster);
  }

  private static Part wall(Face wall, Texture paper) {
    double across = wall.width() / SurfaceTexture.TILE;
    double down = wall.height() / SurfaceTexture.TILE;
    TextureRegion tiles =
        new TextureRegion(firstEdge(across, 0), Math.ceil(down) - down, across, down);
    return painted(new MeshBuilder().quad(wall.quad(), tiles), paper);
  }

  private static Part painted(MeshBuilder mesh, Texture texture) {
    return new Part(mesh.build(), texture, Shading.UNLIT);
  }

  /**
   * Returns the texture region for a tiled floor or ceiling. At the middle of the face, the region
   * shows a given place of a tile.
   *
   * @param tile side length of the tile [m]
   * @param place position within the tile, as a fraction of its side length from the left and from
   *     the top
   */
  private static TextureRegion centered(Face face, double tile, double place) {
    double across = face.width() / tile;
    double down = face.height() / tile;
    return new TextureRegion(firstEdge(across, place), firstEdge(down, place), across, down);
  }

  /**
   * Returns the position within a tile at which the left or upper edge of a face lies, 0 to 1.
   *
   * @param tiles number of tiles across or down the face
   * @param place position within a tile that the middle of the face shows, 0 to 1
   */
  private static double firstEdge(double tiles, double place) {
    double edge = place - tiles / 2;
    return edge - Math.floor(edge);
  }
}
