package tellosimulator.video.camera;

/**
 * Which camera of which drone.
 *
 * @param drone its number, from 1
 * @param downward whether it is the camera that looks at the floor
 */
public record Shot(int drone, boolean downward) {}
