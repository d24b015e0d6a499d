package tellosimulator.scenery;

/** A mesh with a picture on it. */
public record Part(Mesh mesh, Texture texture, Finish finish) {}
