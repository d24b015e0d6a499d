package tellosimulator.scenario;

import java.nio.file.Path;

/**
 * What codecs need to know of the file that they read.
 *
 * @param mistakes to which they tell what is wrong
 * @param folder from which the file names its pictures
 * @param looked whether a picture that is not there is a mistake
 * @param drones how many there are
 */
record Reading(Mistakes mistakes, Path folder, boolean looked, int drones) {

  Reading withDrones(int newDrones) {
    return new Reading(mistakes, folder, looked, newDrones);
  }
}
