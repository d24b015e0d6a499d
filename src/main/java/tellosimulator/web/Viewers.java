package tellosimulator.web;

import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.Optional;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.RenderCache;

/** The open pages. Thread-safe. */
public final class Viewers implements AutoCloseable {

  /** Maximum number of pages. Decided: a group of a class; each takes a part of a processor. */
  static final int MOST = 8;

  private final WebSubject subject;
  private final RenderCache cache = new RenderCache(ColorSpace.RGB);
  private final Map<String, Viewer> viewers = new HashMap<>();
  private final WebPilot pilot;
  private boolean closed;

  public Viewers(WebSubject subject) {
    this.subject = subject;
    pilot = new WebPilot(subject.simulation());
  }

  /**
   * Returns the viewer of a page, which is created if it is new. A page that no stream is open for
   * makes place for a new one.
   *
   * @param name the name that the page has given itself
   */
  synchronized Optional<Viewer> find(String name) {
    Viewer known = viewers.get(name);
    if (known != null) {
      return Optional.of(known);
    }
    for (Iterator<Viewer> each = viewers.values().iterator();
        viewers.size() >= MOST && each.hasNext(); ) {
      if (each.next().idle()) {
        each.remove();
      }
    }
    if (closed || viewers.size() >= MOST) {
      return Optional.empty();
    }
    Viewer viewer = new Viewer(subject, cache, pilot);
    viewers.put(name, viewer);
    return Optional.of(viewer);
  }

  /** Ends all streams. */
  @Override
  public synchronized void close() {
    closed = true;
    viewers.values().forEach(Viewer::close);
    pilot.close();
  }
}
