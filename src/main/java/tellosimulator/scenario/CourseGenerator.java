package tellosimulator.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.OptionalLong;
import java.util.Set;
import java.util.SplittableRandom;
import tellosimulator.math.Frames;
import tellosimulator.world.Room;

/**
 * Generates scenarios without ranges. The included scenarios in the folder {@code course} have
 * ranges, which are replaced by numbers drawn from a seed; mazes get walls. The same arguments give
 * the same text on every machine. Thread-safe.
 */
public final class CourseGenerator {

  /** The kinds of courses. Each has an included scenario for each difficulty. */
  public enum Kind {
    SLALOM,
    GATES,
    SEARCH,
    LANDING_PADS,
    MAZE;

    /** Returns the word for this kind on the command line. */
    public String word() {
      return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
  }

  /** Edge of the cells of a maze [cm], to which the sizes of its rooms fit. */
  private static final int CELL_CM = 120;

  private CourseGenerator() {}

  /** Returns the text of a scenario file. */
  public static String generate(Kind kind, Difficulty difficulty, long seed) {
    String level = difficulty.name().toLowerCase(Locale.ROOT);
    String name = kind.word() + "-" + level + ".yaml";
    try (InputStream input = CourseGenerator.class.getResourceAsStream("course/" + name)) {
      ScenarioDocument course =
          ScenarioFile.open(name, input.readAllBytes(), Path.of(""), OptionalLong.of(seed));
      String head =
          text(
              """
              # tello-simulator generate %s --difficulty %s --seed %d
              # Lengths in cm, angles in degrees; places from the middle of the floor.

              seed: %d   # of noise and gusts
              """,
              kind.word(), level, seed, seed);
      Room room = course.scenario().config().arena().room();
      String walls = kind == Kind.MAZE ? new Maze(room, seed).obstacles() : "";
      return head + course.drawnText() + walls;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (ScenarioException e) {
      throw new IllegalStateException(e);
    }
  }

  private static String text(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }

  /** A maze without islands: exactly one way leads from each cell to each other one. */
  private static final class Maze {

    private final int cells;
    private final int height;
    private final SplittableRandom random;
    private final Set<Set<Cell>> passages = new HashSet<>();

    /** A cell, or a corner between cells. */
    private record Cell(int x, int y) {

      private List<Cell> neighbors(int cells) {
        List<Cell> neighbors = new ArrayList<>();
        for (Cell cell :
            List.of(
                new Cell(x - 1, y), new Cell(x + 1, y), new Cell(x, y - 1), new Cell(x, y + 1))) {
          if (Math.min(cell.x, cell.y) >= 0 && Math.max(cell.x, cell.y) < cells) {
            neighbors.add(cell);
          }
        }
        return neighbors;
      }
    }

    Maze(Room room, long seed) {
      cells = (int) Math.round(Frames.centimeters(room.depth()) / CELL_CM);
      height = (int) Math.round(Frames.centimeters(room.height()));
      random = CourseDraw.random(seed, cells);
      dig();
    }

    /** Opens passages to cells that have none yet, as deep as possible (depth-first search). */
    private void dig() {
      Cell first = new Cell(0, 0);
      Set<Cell> seen = new HashSet<>(Set.of(first));
      Deque<Cell> way = new ArrayDeque<>(seen);
      while (!way.isEmpty()) {
        List<Cell> next = way.peek().neighbors(cells);
        next.removeAll(seen);
        if (next.isEmpty()) {
          way.pop();
        } else {
          Cell chosen = next.get((int) (CourseDraw.fraction(random) * next.size()));
          passages.add(Set.of(way.peek(), chosen));
          seen.add(chosen);
          way.push(chosen);
        }
      }
    }

    /** Returns the section of obstacles: walls that are as long as possible. */
    String obstacles() {
      StringBuilder text = new StringBuilder("\nobstacles:\n");
      for (int line = 1; line < cells; line++) {
        addWalls(line, true, text);
        addWalls(line, false, text);
      }
      return text.toString();
    }

    private void addWalls(int line, boolean alongX, StringBuilder text) {
      int from = 0;
      for (int cell = 0; cell <= cells; cell++) {
        Set<Cell> sides = Set.of(cell(cell, line - 1, alongX), cell(cell, line, alongX));
        if (cell == cells || passages.contains(sides)) {
          if (from < cell) {
            text.append(wall(cell(from, line, alongX), cell(cell, line, alongX)));
          }
          from = cell + 1;
        }
      }
    }

    private static Cell cell(int along, int across, boolean alongX) {
      return alongX ? new Cell(along, across) : new Cell(across, along);
    }

    private String wall(Cell from, Cell to) {
      return text(
          "  - wall: {from: [%d, %d], to: [%d, %d], height: %d, thickness: 4}\n",
          cm(from.x), cm(from.y), cm(to.x), cm(to.y), height);
    }

    private int cm(int line) {
      return line * CELL_CM - cells * CELL_CM / 2;
    }
  }
}
