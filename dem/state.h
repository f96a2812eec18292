// Everything that one step leaves for the next, shown item by item as visit(name, value): whoever
// keeps runs stores the items and puts them back with the same words. What a program makes again
// from its scene (laws, settings, shapes and motions of walls) is not shown.
//
// The bindings name every member, so that a new one does not compile until it was thought of here.
#pragma once

#include <string>

#include "dem/neighbor_list.h"
#include "dem/particle_store.h"
#include "dem/wall.h"

namespace dem {

template <class Visit>
void visit_state(Visit& visit, const std::string& in, ParticleStore& stones) {
  auto& [shell, id, radius, mass, inertia, turning, strength, position, velocity, spin, load,
         softness] = stones;
  visit(in + "shell", shell);
  visit(in + "id", id);
  visit(in + "radius", radius);
  visit(in + "mass", mass);
  visit(in + "inertia", inertia);
  visit(in + "turning", turning);
  visit(in + "strength", strength);
  visit(in + "position", position);
  visit(in + "velocity", velocity);
  visit(in + "spin", spin);
  visit(in + "load", load);
  visit(in + "softness", softness);
}

template <class Visit>
void visit_state(Visit& visit, const std::string& in, Candidates& candidates) {
  auto& [skin, position, radius, id, row_start, second] = candidates;
  visit(in + "skin", skin);
  visit(in + "position", position);
  visit(in + "radius", radius);
  visit(in + "id", id);
  visit(in + "row_start", row_start);
  visit(in + "second", second);
}

template <class Visit>
void visit_state(Visit& visit, const std::string& in, NeighborList& list) {
  auto& [row_start, first, second, previous, candidates] = list;
  visit(in + "row_start", row_start);
  visit(in + "first", first);
  visit(in + "second", second);
  visit(in + "previous", previous);
  visit_state(visit, in + "candidates.", candidates);
}

template <class Visit>
void visit_state(Visit& visit, const std::string& in, SurfaceField& field) {
  visit(in + "velocity", field.velocity);
  visit(in + "fastest", field.fastest);
  visit(in + "displacement", field.displacement);
  visit(in + "impulse", field.impulse);
}

template <class Visit>
void visit_state(Visit& visit, const std::string& in, Wall& wall) {
  auto& [name, surface, frame, motion, field, force, moment, push, moved] = wall;
  visit(in + "frame", frame);
  if (field) visit_state(visit, in + "field.", *field);
  visit(in + "force", force);
  visit(in + "moment", moment);
  visit(in + "push", push);
  visit(in + "moved", moved);
}

}  // namespace dem
